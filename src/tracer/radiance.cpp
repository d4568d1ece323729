#include "tracer/radiance.hpp"

#include <algorithm>
#include <utility>

namespace lancer::tracer {
namespace {

/// No light of a ray counts nothing, however bright it may be.
Color at_most(Color share, Color bound) {
  return {share.r > 0 ? share.r * bound.r : 0, share.g > 0 ? share.g * bound.g : 0,
          share.b > 0 ? share.b * bound.b : 0};
}

}  // namespace

Color Tracer::radiance(const Ray& ray, int depth) {
  const Plan& plan = *tracing_.plan;
  if (!plan.recursion && !plan.faint_lights) return one_surface(ray);
  if (tracing_.world->scene->settings.sum == scene::Sum::log) return log(ray, depth);
  return plan.faint_rays || plan.faint_lights ? linear_to_error(ray, depth) : linear(ray, depth);
}

Color Tracer::one_surface(const Ray& ray) {
  Hit hit;
  if (!closest(*tracing_.world, ray, stats_, hit)) return tracing_.world->scene->settings.background;
  return shade(tracing_, ray, hit, false, stats_, {grey(1), nullptr, cells()}).own.value();
}

Color Tracer::linear(const Ray& ray, int depth) {
  Color sum;
  follow(ray, grey(1), depth, sum);
  return sum;
}

void Tracer::follow(const Ray& first, Color first_share, int depth, Color& sum) {
  const scene::Settings& settings = tracing_.world->scene->settings;
  pending_.clear();
  Pending now{first, first_share, depth};
  Hit hit;
  while (!tracing_.cancelled()) {
    bool goes_on = false;
    if (closest(*tracing_.world, now.ray, stats_, hit)) {
      const Color share = now.share;
      Shaded shaded = shade(tracing_, now.ray, hit, now.depth > 0, stats_, {grey(1), nullptr, cells()});
      sum += share * shaded.own.value();
      const int left = now.depth - 1;
      const auto go_on = [&](std::optional<Branch>& branch, std::uint64_t& count) {
        if (!branch) return;
        const Color counts = share * (branch->share + branch->also);
        if (is_black(counts)) return;
        ++count;
        if (goes_on) pending_.push_back(std::move(now));
        now.ray = std::move(branch->ray);
        now.share = counts;
        now.depth = left;
        goes_on = true;
      };
      go_on(shaded.reflected, stats_.reflected_rays);
      go_on(shaded.transmitted, stats_.refracted_rays);
    } else {
      sum += now.share * settings.background;
    }
    if (goes_on) continue;
    if (pending_.empty()) break;
    now = std::move(pending_.back());
    pending_.pop_back();
  }
}

Color Tracer::allowance(Color seen) const {
  const Plan& plan = *tracing_.plan;
  const auto of = [&](double light) {
    return plan.faint_error / plan.exposure * tolerance(light * plan.exposure);
  };
  return {of(seen.r), of(seen.g), of(seen.b)};
}

Color Tracer::linear_to_error(const Ray& first, int depth) {
  const Plan& plan = *tracing_.plan;
  const scene::Settings& settings = tracing_.world->scene->settings;
  Color sum, lost;
  brightest_.clear();
  brightest_.push({first, grey(1), depth}, {});
  Hit hit;
  for (bool is_first = true; !brightest_.empty() && !tracing_.cancelled(); is_first = false) {
    if (!is_first && plan.faint_rays && brightest_.fit(allowance(sum) - lost)) {
      stats_.rays_faint += brightest_.size();
      break;
    }
    const Pending now = brightest_.pop();
    if (!is_first) ++(now.transmitted ? stats_.refracted_rays : stats_.reflected_rays);
    if (!closest(*tracing_.world, now.ray, stats_, hit)) {
      sum += now.share * settings.background;
      continue;
    }
    const Color for_lights = allowance(sum) * 0.5 - lost;
    Allowance lights(for_lights);
    Shaded shaded = shade(tracing_, now.ray, hit, now.depth > 0, stats_,
                          {now.share, plan.faint_lights ? &lights : nullptr, cells()});
    lost += for_lights - lights.left();
    sum += now.share * shaded.own.value();
    const auto follow = [&](std::optional<Branch>& branch, bool transmitted) {
      if (!branch) return;
      const Color share = now.share * (branch->share + branch->also);
      if (is_black(share)) return;
      const Color most = plan.faint_rays ? at_most(share, plan.brightness.bound(now.depth - 1)) : Color{};
      brightest_.push({std::move(branch->ray), share, now.depth - 1, transmitted}, most);
    };
    follow(shaded.reflected, false);
    follow(shaded.transmitted, true);
  }
  return sum;
}

void Tracer::drop_if_faint(std::optional<Branch>& branch, Color reach, int depth, Allowance& allowance) {
  const Plan& plan = *tracing_.plan;
  if (!branch || !plan.faint_rays) return;
  // Joined terms are no more than their sum, and each counts no more than 1.
  const Color most = at_most(branch->share + branch->also, plan.brightness.bound(depth));
  const Color counted{std::min(most.r, 1.0), std::min(most.g, 1.0), std::min(most.b, 1.0)};
  if (!allowance.takes(reach * counted)) return;
  ++stats_.rays_faint;
  branch.reset();
}

Color Tracer::log(Ray ray, int depth) {
  const scene::Settings& settings = tracing_.world->scene->settings;
  const Plan& plan = *tracing_.plan;
  Allowance allowed(allowance({}));
  Color reach = grey(1);
  waiting_.clear();
  later_.clear();
  Hit hit;
  while (!tracing_.cancelled()) {
    // Down: along first branches, to a surface without any.
    Color value = settings.background;
    if (closest(*tracing_.world, ray, stats_, hit)) {
      Shaded shaded = shade(tracing_, ray, hit, depth > 0, stats_,
                            {reach, plan.faint_lights ? &allowed : nullptr, cells()});
      value = shaded.own.value();
      drop_if_faint(shaded.reflected, reach, depth - 1, allowed);
      drop_if_faint(shaded.transmitted, reach, depth - 1, allowed);
      if (!shaded.own.is_full() && (shaded.reflected || shaded.transmitted)) {
        stats_.reflected_rays += shaded.reflected ? 1 : 0;
        stats_.refracted_rays += shaded.transmitted ? 1 : 0;
        const bool both = shaded.reflected && shaded.transmitted;
        Branch first = std::move(shaded.reflected ? *shaded.reflected : *shaded.transmitted);
        if (both) later_.push_back(std::move(*shaded.transmitted));
        waiting_.push_back({shaded.own, first.share, first.also, reach, depth, both});
        reach = reach * (first.share + first.also) * (grey(1) - value);
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
        reach = top.reach * (second.share + second.also) * (grey(1) - value);
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
