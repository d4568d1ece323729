#include "stress/truth/way_out.hpp"

#include "stress/truth/box.hpp"
#include "stress/truth/first_hit.hpp"

namespace lancer::stress::flat {

WayOut farthest_facet(const tracer::World& world, Vec3 o, Vec3 d) {
  WayOut out;
  for (const tracer::FacetPrimitive& f : world.facets) {
    const Truth one = facet_truth(numbers_of(f), o, d);
    if (!one.hit || (out.judged && one.t < out.t)) continue;
    out.judged = true;
    out.t = one.t;
  }
  return out;
}

WayOut way_out(const tracer::World& world, std::uint32_t primitive, Vec3 o, Vec3 d) {
  const tracer::Primitive& p = world.primitives[primitive];
  WayOut out;
  const auto of_round = [&](const stress::Truth& truth) {
    out = {truth.hit && !truth.open && !truth.in_band, truth.t};
  };
  switch (p.kind) {
    case tracer::Kind::sphere: of_round(first_hit(world.spheres[p.record], Sight{o, d, true})); break;
    case tracer::Kind::ellipsoid: of_round(first_hit(world.ellipsoids[p.record], Sight{o, d, true})); break;
    case tracer::Kind::box: {
      const Truth truth = box_way_out(numbers_of(world.boxes[p.record]), o, d);
      out = {truth.hit, truth.t};
      break;
    }
    case tracer::Kind::facet: out = farthest_facet(world, o, d); break;
    case tracer::Kind::plane: break;
  }
  // A chord no longer than what the start may be off by.
  constexpr double k_band = 64 * 0x1p-53;
  if (out.judged && out.t <= Real(k_band * max_abs(o))) out.judged = false;
  return out;
}

}  // namespace lancer::stress::flat
