#include "tracer/packet/block.hpp"

#include <algorithm>

namespace lancer::tracer {

BlockTracer::BlockTracer(const PacketWorld& packets, const Tracing& tracing, Tracer& single)
    : packets_(packets),
      tracing_(tracing),
      single_(single),
      lists_(*tracing.world),
      found_(std::make_unique<FirstHits>()),
      hits_(std::make_unique<Hits>()),
      lighting_(std::make_unique<Lighting>()),
      onward_(std::make_unique<Onward>()) {}

BlockTracer::~BlockTracer() = default;

void BlockTracer::add_rays(const Camera& camera, std::span<const ScreenPoint> points) {
  terms_.begin(points.size());
  for (std::size_t first = 0; first < points.size();) {
    Rays& rays = waves_.room(0, false);
    rays.from_eye = true;
    rays.count = std::min(k_wave, points.size() - first);
    const ScreenPoint* const at = points.data() + first;
    LANCER_ON_TARGET(aim(camera.aim(), at, rays.count, rays.origin, rays.direction, onward_->known));
    for (std::size_t i = 0; i < rays.count; ++i) {
      rays.share.set(i, grey(1));
      rays.term[i] = static_cast<std::uint32_t>(first + i);
      if (onward_->known[i] != 0) continue;
      const CameraRay ray = camera.ray(at[i].x, at[i].y);
      rays.origin.set(i, ray.origin);
      rays.direction.set(i, ray.direction);
    }
    first += rays.count;
  }
}

void BlockTracer::radiances(int depth, std::span<Color> out) {
  depth_ = depth;
  while (std::unique_ptr<Rays> wave = waves_.take()) {
    if (!tracing_.cancelled()) trace(*wave);
    waves_.give_back(std::move(wave));
  }
  for (std::uint32_t i = 0; i < out.size() && !tracing_.cancelled(); ++i) {
    Color& sum = out[i] = {};
    terms_.each(i, [&](const LightTree::Part& term) {
      if (term.late != LightTree::k_never) {
        const Pending& late = late_[term.late];
        single_.follow(late.ray, late.share, late.depth, sum);
      } else {
        sum += term.light;
      }
    });
  }
  late_.clear();
  lists_.tidy();
}

void BlockTracer::trace(Rays& rays) {
  rays_ = &rays;
  Stats& stats = single_.stats();
  const OpenRow* const open = tracing_.plan->media ? lists_.rows() : nullptr;
  RaysView view{&rays.origin, &rays.direction, nullptr, nullptr, nullptr, rays.count};
  if (!rays.from_eye) {
    view = {&rays.origin, &rays.direction, &rays.starts, &rays.exits, open, rays.count};
    LANCER_ON_TARGET(find_exits(packets_.scenery(), view, nullptr, rays.exits));
  }
  Work work;
  LANCER_ON_TARGET(find_closest(packets_.scenery(), view, *found_, work));
  stats.shape_tests += work.shape_tests;
  stats.node_visits += work.node_visits;
  sort_found();
  land();
  find_surfaces(tracing_, packets_.looks(), *hits_, rays.level < depth_, stats);
  add_lights(tracing_, packets_.scenery(), *hits_, *lighting_, stats);
  add_hits();
  if (rays.level < depth_ && tracing_.plan->recursion) go_on();
}

void BlockTracer::sort_found() {
  const std::vector<Look>& looks = packets_.looks().primitives;
  const Color background = tracing_.world->scene->settings.background;
  const Rays& rays = *rays_;
  std::array<Places, k_grounds> on;
  for (Places& places : on) places.count = 0;
  for (std::size_t i = 0; i < rays.count; ++i) {
    if (found_->seen[i] == Outlook::surface) {
      Places& places = on[static_cast<std::size_t>(looks[primitive_of(found_->primitive[i])].ground)];
      places.at[places.count++] = static_cast<std::uint16_t>(i);
    } else if (found_->seen[i] == Outlook::in_doubt) {
      trace_alone(i);
    } else {
      terms_[rays.term[i]].light = rays.share[i] * background;
    }
  }
  hits_->count = 0;
  for (std::size_t kind = 0; kind < k_grounds; ++kind) {
    Places& places = on[kind];
    hits_->first[kind] = hits_->count;
    hits_->on[kind] = places.count;
    if (places.count == 0) continue;
    std::size_t room = places.count;
    for (; room % 4 != 0; ++room) places.at[room] = places.at[places.count - 1];
    add_found({places.at.data(), room}, places.count);
  }
}

void BlockTracer::add_found(std::span<const std::uint16_t> from, std::size_t there) {
  const Rays& rays = *rays_;
  Hits& hits = *hits_;
  const std::size_t first = hits.count;
  hits.count += from.size();
  const auto pick = [&](auto& to, const auto& column) {
    for (std::size_t i = 0; i < from.size(); ++i) to[first + i] = column[from[i]];
  };
  const auto each = [&](const auto& set) {
    for (std::size_t i = 0; i < from.size(); ++i) set(first + i, from[i]);
  };
  pick(hits.origin.x, rays.origin.x);
  pick(hits.origin.y, rays.origin.y);
  pick(hits.origin.z, rays.origin.z);
  pick(hits.direction.x, rays.direction.x);
  pick(hits.direction.y, rays.direction.y);
  pick(hits.direction.z, rays.direction.z);
  pick(hits.share.r, rays.share.r);
  pick(hits.share.g, rays.share.g);
  pick(hits.share.b, rays.share.b);
  pick(hits.term, rays.term);
  pick(hits.entering, found_->entering);
  pick(hits.t, found_->t);
  pick(hits.error, found_->error);
  each([&](std::size_t at, std::size_t i) {
    hits.ray[at] = static_cast<std::uint16_t>(i);
    hits.primitive[at] = primitive_of(found_->primitive[i]);
    hits.face[at] = face_of(found_->primitive[i]);
    hits.there[at] = at - first < there ? -1 : 0;
  });
  if (rays.from_eye) {
    each([&](std::size_t at, std::size_t) {
      hits.start_error[at] = 0;
      hits.exits[at] = 0;
      hits.open[at] = OpenLists::k_none;
    });
    return;
  }
  pick(hits.start_error, rays.starts.error);
  pick(hits.open, rays.starts.open);
  each([&](std::size_t at, std::size_t i) {
    const bool same = rays.starts.primitive[i] == static_cast<long long>(hits.primitive[at]);
    hits.exits[at] = same ? rays.starts.passes[i] : 0;
  });
}

void BlockTracer::land() {
  Hits& hits = *hits_;
  const auto view = [&](Ground kind) {
    const auto k = static_cast<std::size_t>(kind);
    return LandingView{&hits.origin,   &hits.direction, &hits.start_error, hits.primitive.at.data(),
                       &hits.entering, &hits.face,      &hits.exits,       hits.first[k],
                       hits.on[k],     &hits.t,         &hits.error,       &hits.point,
                       &hits.normal,   &hits.settled};
  };
  const Scenery& scenery = packets_.scenery();
  LANCER_ON_TARGET(land_on_spheres(scenery, view(Ground::sphere)));
  LANCER_ON_TARGET(land_across(scenery, 0, view(Ground::plane_x)));
  LANCER_ON_TARGET(land_across(scenery, 1, view(Ground::plane_y)));
  LANCER_ON_TARGET(land_across(scenery, 2, view(Ground::plane_z)));
  LANCER_ON_TARGET(land_on_facets(scenery, view(Ground::facet)));
  LANCER_ON_TARGET(land_on_boxes(scenery, view(Ground::box)));
  LANCER_ON_TARGET(land_on_tilted_planes(scenery, view(Ground::tilted_plane)));
  LANCER_ON_TARGET(land_on_turned_boxes(scenery, view(Ground::turned_box)));
  land_others();
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (hits.there[i] == 0 || hits.settled[i] != 0) continue;
    hits.there[i] = 0;
    trace_alone(hits.ray[i]);
  }
}

/// What has no kernel.
void BlockTracer::land_others() {
  Hits& hits = *hits_;
  const std::size_t others = hits.first[static_cast<std::size_t>(Ground::other)];
  for (std::size_t i = others; i < hits.count; ++i) {
    Hit hit;
    const Ray ray = single_ray(*tracing_.world, *rays_, hits.ray[i], lists_);
    hits.settled[i] = land_alone(*tracing_.world, ray, hits.primitive[i], hits.exits[i] != 0, hit) ? -1 : 0;
    hits.t[i] = hit.root.t;
    hits.error[i] = hit.point_error;
    hits.entering[i] = hit.root.entering ? -1 : 0;
    hits.face[i] = hit.root.face;
    hits.point.set(i, hit.point);
    hits.normal.set(i, hit.normal);
  }
}

void BlockTracer::add_hits() {
  const Hits& hits = *hits_;
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (hits.there[i] != 0) terms_[hits.term[i]].light = hits.share[i] * hits.own[i];
  }
}

void BlockTracer::trace_alone(std::size_t ray) {
  trace_alone({single_ray(*tracing_.world, *rays_, ray, lists_), rays_->share[ray], depth_ - rays_->level},
              rays_->term[ray]);
}

void BlockTracer::trace_alone(Pending ray, std::uint32_t term) {
  const bool follow = tracing_.plan->recursion;
  lone_.push_back({std::move(ray), term});
  Hit hit;
  while (!lone_.empty() && !tracing_.cancelled()) {
    const Lone now = std::move(lone_.back());
    lone_.pop_back();
    if (!closest(*tracing_.world, now.ray.ray, single_.stats(), hit)) {
      terms_[now.term].light = now.ray.share * tracing_.world->scene->settings.background;
      continue;
    }
    Shaded shaded = shade(tracing_, now.ray.ray, hit, follow && now.ray.depth > 0, single_.stats());
    terms_[now.term].light = now.ray.share * shaded.own.value();
    add_branch(shaded.reflected, now.ray, now.term, false);
    add_branch(shaded.transmitted, now.ray, now.term, true);
  }
}

void BlockTracer::add_branch(std::optional<Branch>& branch, const Pending& from, std::uint32_t surface,
                             bool transmitted) {
  if (!branch) return;
  const Color share = from.share * (branch->share + branch->also);
  if (is_black(share)) return;
  Stats& stats = single_.stats();
  ++(transmitted ? stats.refracted_rays : stats.reflected_rays);
  Pending next{std::move(branch->ray), share, from.depth - 1};
  const std::uint32_t term = terms_.add(surface, transmitted);
  if (!rejoin(next, term, transmitted)) lone_.push_back({std::move(next), term});
}

}  // namespace lancer::tracer
