#include "tracer/packet/block.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/media.hpp"
#include "tracer/optics.hpp"

namespace lancer::tracer {

BlockTracer::BlockTracer(const PacketWorld& packets, const Tracing& tracing, Tracer& single)
    : packets_(packets),
      tracing_(tracing),
      single_(single),
      rays_(std::make_unique<Rays>()),
      next_(std::make_unique<Rays>()),
      found_(std::make_unique<FirstHits>()),
      hits_(std::make_unique<Hits>()),
      lighting_(std::make_unique<Lighting>()) {}

BlockTracer::~BlockTracer() = default;

void BlockTracer::add_ray(const CameraRay& ray, std::size_t pixel) {
  const std::size_t i = rays_->count++;
  rays_->origin.set(i, ray.origin);
  rays_->direction.set(i, ray.direction);
  rays_->share.set(i, grey(1));
  rays_->pixel[i] = static_cast<std::uint16_t>(pixel);
}

void BlockTracer::add_radiance(int depth, Color* sums) {
  sums_ = sums;
  Stats& stats = single_.stats();
  for (from_eye_ = true; rays_->count > 0 && !tracing_.cancelled(); from_eye_ = false, --depth) {
    Work work;
    LANCER_ON_TARGET(
        find_closest(packets_.scenery(),
                     {&rays_->origin, &rays_->direction, from_eye_ ? nullptr : &rays_->starts, rays_->count},
                     *found_, work));
    stats.shape_tests += work.shape_tests;
    stats.node_visits += work.node_visits;
    sort_found(depth);
    land(depth);
    find_surfaces(tracing_, *hits_, depth > 0, stats);
    add_lights(tracing_, packets_.scenery(), *hits_, *lighting_, stats);
    add_hits(depth);
    std::swap(rays_, next_);
  }
}

void BlockTracer::follow_alone(std::size_t ray, int depth) {
  single_.follow(rays_->ray(ray, from_eye_), rays_->share[ray], depth, sums_[rays_->pixel[ray]]);
}

void BlockTracer::sort_found(int depth) {
  const World& world = *tracing_.world;
  std::array<std::array<std::uint16_t, k_wave>, k_grounds> on;
  std::array<std::size_t, k_grounds> count{};
  for (std::size_t i = 0; i < rays_->count; ++i) {
    if (found_->seen[i] == Outlook::surface) {
      const auto kind =
          static_cast<std::size_t>(ground(world, static_cast<std::uint32_t>(found_->primitive[i])));
      on[kind][count[kind]++] = static_cast<std::uint16_t>(i);
    } else if (found_->seen[i] == Outlook::in_doubt) {
      follow_alone(i, depth);
    } else {
      sums_[rays_->pixel[i]] += rays_->share[i] * world.scene->settings.background;
    }
  }
  Hits& hits = *hits_;
  hits.count = 0;
  for (std::size_t kind = 0; kind < k_grounds; ++kind) {
    hits.first[kind] = hits.count;
    hits.on[kind] = count[kind];
    const std::size_t room = (count[kind] + 3) / 4 * 4;
    for (std::size_t k = 0; k < room; ++k) {
      const std::size_t i = on[kind][std::min(k, count[kind] - 1)], at = hits.count++;
      hits.ray[at] = static_cast<std::uint16_t>(i);
      hits.origin.set(at, rays_->origin[i]);
      hits.direction.set(at, rays_->direction[i]);
      hits.start_error[at] = from_eye_ ? 0 : rays_->starts.error[i];
      hits.primitive[at] = static_cast<std::uint32_t>(found_->primitive[i]);
      hits.entering[at] = found_->entering[i];
      hits.t[at] = found_->t[i];
      hits.error[at] = found_->error[i];
      hits.face[at] = 0;
      hits.there[at] = k < count[kind] ? -1 : 0;
    }
  }
}

void BlockTracer::land(int depth) {
  Hits& hits = *hits_;
  const auto view = [&](Ground kind) {
    const auto k = static_cast<std::size_t>(kind);
    return LandingView{&hits.origin,   &hits.direction, &hits.start_error, hits.primitive.at.data(),
                       &hits.entering, hits.first[k],   hits.on[k],        &hits.t,
                       &hits.error,    &hits.point,     &hits.normal,      &hits.settled};
  };
  const Scenery& scenery = packets_.scenery();
  LANCER_ON_TARGET(land_on_spheres(scenery, view(Ground::sphere)));
  LANCER_ON_TARGET(land_across(scenery, 0, view(Ground::plane_x)));
  LANCER_ON_TARGET(land_across(scenery, 1, view(Ground::plane_y)));
  LANCER_ON_TARGET(land_across(scenery, 2, view(Ground::plane_z)));
  LANCER_ON_TARGET(land_on_facets(scenery, view(Ground::facet)));
  const std::size_t others = hits.first[static_cast<std::size_t>(Ground::other)];
  for (std::size_t i = others; i < hits.count; ++i) {
    Hit hit;
    hits.settled[i] =
        land_alone(*tracing_.world, rays_->ray(hits.ray[i], from_eye_), hits.primitive[i], hit) ? -1 : 0;
    hits.t[i] = hit.root.t;
    hits.error[i] = hit.point_error;
    hits.entering[i] = hit.root.entering ? -1 : 0;
    hits.face[i] = hit.root.face;
    hits.point.set(i, hit.point);
    hits.normal.set(i, hit.normal);
  }
  const auto splits = [&](std::size_t i) {
    const Plan& plan = *tracing_.plan;
    return depth > 0 && plan.recursion && packets_.splits(hits.primitive[i]);
  };
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (hits.there[i] == 0 || (hits.settled[i] != 0 && !splits(i))) continue;
    hits.there[i] = 0;
    follow_alone(hits.ray[i], depth);
  }
}

void BlockTracer::add_hits(int depth) {
  const Hits& hits = *hits_;
  next_->count = 0;
  bool any = false;
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (hits.there[i] == 0) continue;
    const std::size_t ray = hits.ray[i];
    sums_[rays_->pixel[ray]] += rays_->share[ray] * hits.own[i];
    any = any || hits.needs[i]->onward;
  }
  if (depth > 0 && any) reflect(depth);
}

void BlockTracer::reflect(int depth) {
  const Hits& hits = *hits_;
  Stats& stats = single_.stats();
  Lighting& room = *lighting_;
  LANCER_ON_TARGET(mirror(hits.direction, hits.facing, room.towards, room.known, hits.count));
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (hits.there[i] == 0 || !hits.needs[i]->onward) continue;
    ++stats.branchings;
    if (is_black(hits.reflection[i])) continue;
    const Color share = rays_->share[hits.ray[i]] * (hits.reflection[i] + Color{});
    if (is_black(share)) continue;
    ++stats.reflected_rays;
    const Vec3 direction = room.known[i] != 0 ? room.towards[i] : mirrored(hits.direction[i], hits.facing[i]);
    const double outward = dot(hits.normal[i], direction);
    const bool inside = outward < 0;
    const Contact contact = hits.contact(*tracing_.world, i, inside, true);
    if (tracing_.plan->media && hits.convex[i] != 0) {
      ++stats.medium_changes;
      if (inside) {
        // Rays that go together are in no solid.
        Ray ray{hits.point[i], direction, hits.error[i], {}, {}};
        ray.contacts.push_back(contact);
        cross(*tracing_.world, ray.open, contact.shape, true);
        single_.follow(ray, share, depth - 1, sums_[rays_->pixel[hits.ray[i]]]);
        continue;
      }
    }
    const std::size_t to = next_->count++;
    next_->origin.set(to, hits.point[i]);
    next_->direction.set(to, direction);
    next_->share.set(to, share);
    next_->pixel[to] = rays_->pixel[hits.ray[i]];
    next_->starts.error[to] = hits.error[i];
    next_->starts.primitive[to] = hits.primitive_word[i];
    next_->starts.shape[to] = hits.shape[i];
    next_->starts.rise[to] = std::fabs(outward);
    next_->starts.passes[to] = hits.convex[i] != 0 && inside ? -1 : 0;
    next_->contact[to] = contact;
  }
}

}  // namespace lancer::tracer
