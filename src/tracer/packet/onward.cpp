// How light goes on from the hits of a wave.

#include <algorithm>
#include <cmath>

#include "tracer/optics.hpp"
#include "tracer/packet/block.hpp"

namespace lancer::tracer {
namespace {

/// More terms than these take more room than they are worth: what goes on is then followed when sums are
/// made.
constexpr std::size_t k_most_terms = 1U << 19;
constexpr int k_deepest = 64;  // waves of the few rays that go on so long are not worth it

}  // namespace

void BlockTracer::bend() {
  const Hits& hits = *hits_;
  const Plan& plan = *tracing_.plan;
  Onward& room = *onward_;
  std::uint64_t changes = 0;
  for (std::size_t i = 0; i < hits.count; ++i) {
    room.from[i] = room.to[i] = 1;
    const auto open = static_cast<std::uint32_t>(hits.open[i]);
    room.beyond[i] = open;
    if (!plan.media || hits.onward[i] == 0 || is_black(hits.transmission[i])) continue;
    ++changes;
    room.beyond[i] = lists_.crossed(open, static_cast<std::uint32_t>(hits.shape[i]), hits.entering[i] != 0);
    room.from[i] = lists_.refractive_index(open);
    room.to[i] = lists_.refractive_index(static_cast<std::uint32_t>(room.beyond[i]));
  }
  single_.stats().medium_changes += changes;
  const bool all_known =
      LANCER_ON_TARGET(bend({&hits.onward, &hits.direction, &hits.facing, &room.from, &room.to,
                             &room.bent.direction, &room.total, &room.known, &room.reflectance},
                            hits.count));
  for (std::size_t i = 0; i < hits.count && !all_known; ++i) {
    if (room.known[i] != 0 || room.total[i] != 0 || hits.onward[i] == 0) continue;
    const auto bent = refracted(hits.direction[i], hits.facing[i], room.from[i], room.to[i]);
    if (bent) room.bent.direction.set(i, *bent);
  }
}

void BlockTracer::go_on() {
  const Hits& hits = *hits_;
  Onward& room = *onward_;
  const std::uint64_t count = LANCER_ON_TARGET(count_set(hits.onward, hits.count));
  if (count == 0) return;
  single_.stats().branchings += count;
  const bool clear = hits.any_transmission;
  if (clear) bend();
  LANCER_ON_TARGET(split({&hits.share, &hits.reflection, clear ? &hits.transmission : nullptr, &hits.onward,
                          &hits.fresnel, &room.total, &room.reflectance, &room.mirrored.share,
                          &room.bent.share, &room.mirrored.goes, &room.bent.goes},
                         hits.count));
  if (clear) turn_off(room.bent, room.beyond, true);
  const bool all_known = LANCER_ON_TARGET(mirror(hits.direction, hits.facing, room.mirrored.goes,
                                                 room.mirrored.direction, room.known, hits.count));
  for (std::size_t i = 0; i < hits.count && !all_known; ++i) {
    if (room.known[i] == 0 && room.mirrored.goes[i] != 0)
      room.mirrored.direction.set(i, mirrored(hits.direction[i], hits.facing[i]));
  }
  turn_off(room.mirrored, hits.open, false);
}

void BlockTracer::turn_off(Turned& turned, const Words& open, bool transmitted) {
  const Hits& hits = *hits_;
  Stats& stats = single_.stats();
  LANCER_ON_TARGET(
      turn({&turned.direction, &hits.normal, &hits.convex, &turned.rise, &turned.inside, &turned.passes},
           hits.count));
  Places goes;
  goes.count = 0;
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (turned.goes[i] == 0) continue;
    turned.open[i] = open[i];
    if (tracing_.plan->media && hits.convex[i] != 0) {
      ++stats.medium_changes;
      turned.open[i] = lists_.crossed(static_cast<std::uint32_t>(open[i]),
                                      static_cast<std::uint32_t>(hits.shape[i]), turned.inside[i] != 0);
    }
    if (!is_black(turned.share[i])) goes.at[goes.count++] = static_cast<std::uint16_t>(i);
  }
  (transmitted ? stats.refracted_rays : stats.reflected_rays) += goes.count;
  const auto is_enough = [&] { return rays_->level >= k_deepest || terms_.size() > k_most_terms; };
  for (std::size_t i = 0; i < goes.count && is_enough(); ++i) add_late(turned, goes.at[i], transmitted);
  if (is_enough()) return;
  for (std::size_t first = 0; first < goes.count;) {
    Rays& next = waves_.room(rays_->level + 1, transmitted);
    const std::size_t some = std::min(goes.count - first, k_wave - next.count);
    add_turned(next, turned, {goes.at.data() + first, some}, transmitted);
    first += some;
  }
}

void BlockTracer::add_turned(Rays& next, const Turned& turned, std::span<const std::uint16_t> from,
                             bool transmitted) {
  const Hits& hits = *hits_;
  const std::size_t first = next.count;
  next.count += from.size();
  const auto pick = [&](auto& to, const auto& column) {
    for (std::size_t i = 0; i < from.size(); ++i) to[first + i] = column[from[i]];
  };
  const auto pick3 = [&](Vec3s& to, const Vec3s& column) {
    pick(to.x, column.x);
    pick(to.y, column.y);
    pick(to.z, column.z);
  };
  pick3(next.origin, hits.point);
  pick3(next.direction, turned.direction);
  pick3(next.normal, hits.normal);
  pick(next.face, hits.face);
  pick(next.share.r, turned.share.r);
  pick(next.share.g, turned.share.g);
  pick(next.share.b, turned.share.b);
  pick(next.starts.error, hits.error);
  pick(next.starts.primitive, hits.primitive_word);
  pick(next.starts.shape, hits.shape);
  pick(next.starts.rise, turned.rise);
  pick(next.starts.passes, turned.passes);
  pick(next.starts.open, turned.open);
  for (std::size_t i = 0; i < from.size(); ++i)
    next.term[first + i] = terms_.add(hits.term[from[i]], transmitted);
}

void BlockTracer::add_late(const Turned& turned, std::size_t i, bool transmitted) {
  const Hits& hits = *hits_;
  Ray ray{hits.point[i],
          turned.direction[i],
          hits.error[i],
          {},
          lists_.open(static_cast<std::uint32_t>(turned.open[i]))};
  ray.contacts.push_back(contact_at(*tracing_.world, hits.primitive[i], hits.face[i], hits.normal[i],
                                    turned.inside[i] != 0, true));
  add_late({std::move(ray), turned.share[i], depth_ - rays_->level - 1},
           terms_.add(hits.term[i], transmitted));
}

void BlockTracer::add_late(Pending ray, std::uint32_t term) {
  terms_[term].late = static_cast<std::uint32_t>(late_.size());
  late_.push_back(std::move(ray));
}

bool BlockTracer::rejoin(const Pending& pending, std::uint32_t term, bool transmitted) {
  const Ray& ray = pending.ray;
  if (depth_ - pending.depth > k_deepest || terms_.size() > k_most_terms) {
    add_late(pending, term);
    return true;
  }
  if (ray.contacts.size() != 1) return false;
  const World& world = *tracing_.world;
  const Contact& own = ray.contacts[0];
  const double outward = dot(own.normal, ray.direction);
  const Contact told = contact_at(world, own.primitive, own.face, own.normal, outward < 0, true);
  const bool is_usual =
      own.left && own.inside == told.inside && own.in_shape == told.in_shape && own.joined == told.joined;
  if (!is_usual) return false;
  Rays& next = waves_.room(depth_ - pending.depth, transmitted);
  const std::size_t to = next.count++;
  next.origin.set(to, ray.origin);
  next.direction.set(to, ray.direction);
  next.normal.set(to, own.normal);
  next.face[to] = own.face;
  next.share.set(to, pending.share);
  next.term[to] = term;
  next.starts.error[to] = ray.origin_error;
  next.starts.primitive[to] = own.primitive;
  next.starts.shape[to] = own.shape;
  next.starts.rise[to] = std::fabs(outward);
  next.starts.passes[to] = is_convex_solid(world.primitives[own.primitive].kind) && outward < 0 ? -1 : 0;
  next.starts.open[to] = lists_.find(ray.open);
  return true;
}

}  // namespace lancer::tracer
