#include "tracer/radiance.hpp"

#include <utility>

namespace lancer::tracer {

Color Tracer::radiance(Ray ray, int depth) {
  return tracing_.world->scene->settings.sum == scene::Sum::linear ? linear(std::move(ray), depth)
                                                                   : log(std::move(ray), depth);
}

Color Tracer::linear(Ray first, int depth) {
  const scene::Settings& settings = tracing_.world->scene->settings;
  Color sum;
  pending_.clear();
  pending_.push_back({std::move(first), grey(1), depth});
  Hit hit;
  while (!pending_.empty() && !tracing_.cancelled()) {
    const Pending now = std::move(pending_.back());
    pending_.pop_back();
    if (!closest(*tracing_.world, now.ray, stats_, hit)) {
      sum += now.share * settings.background;
      continue;
    }
    Shaded shaded = shade(tracing_, now.ray, hit, now.depth > 0, stats_);
    sum += now.share * shaded.own.value();
    const auto follow = [&](std::optional<Branch>& branch, std::uint64_t& count) {
      if (!branch) return;
      const Color share = now.share * (branch->share + branch->also);
      if (is_black(share)) return;
      ++count;
      pending_.push_back({std::move(branch->ray), share, now.depth - 1});
    };
    follow(shaded.reflected, stats_.reflected_rays);
    follow(shaded.transmitted, stats_.refracted_rays);
  }
  return sum;
}

Color Tracer::log(Ray ray, int depth) {
  const scene::Settings& settings = tracing_.world->scene->settings;
  waiting_.clear();
  later_.clear();
  Hit hit;
  while (!tracing_.cancelled()) {
    // Down: along first branches, to a surface without any.
    Color value = settings.background;
    if (closest(*tracing_.world, ray, stats_, hit)) {
      Shaded shaded = shade(tracing_, ray, hit, depth > 0, stats_);
      value = shaded.own.value();
      if (!shaded.own.is_full() && (shaded.reflected || shaded.transmitted)) {
        stats_.reflected_rays += shaded.reflected ? 1 : 0;
        stats_.refracted_rays += shaded.transmitted ? 1 : 0;
        const bool both = shaded.reflected && shaded.transmitted;
        Branch first = std::move(shaded.reflected ? *shaded.reflected : *shaded.transmitted);
        if (both) later_.push_back(std::move(*shaded.transmitted));
        waiting_.push_back({shaded.own, first.share, first.also, depth, both});
        ray = std::move(first.ray);
        --depth;
        continue;
      }
    }
    // Up: to the next surface that waits for a second ray.
    bool down_again = false;
    while (!waiting_.empty() && !down_again) {
      Waiting& top = waiting_.back();
      top.value.add(top.share * value);
      top.value.add(top.also * value);
      value = top.value.value();
      depth = top.depth;
      if (top.then_transmitted) {
        Branch second = std::move(later_.back());
        later_.pop_back();
        top.share = second.share;
        top.also = second.also;
        top.then_transmitted = false;
        ray = std::move(second.ray);
        --depth;
        down_again = true;
      } else {
        waiting_.pop_back();
      }
    }
    if (!down_again) return value;
  }
  return {};
}

}  // namespace lancer::tracer
