#include "stress/truth/side.hpp"

#include <algorithm>

#include "stress/truth/exact_sign.hpp"

namespace lancer::stress::flat {
namespace {

template <class Number>
Triple<Number> mapped(const tracer::Rows& rows, Vec3 center, Vec3 p) {
  const Triple<Number> offset = as<Number>(p) - as<Number>(center);
  return {dot(as<Number>(rows[0]), offset), dot(as<Number>(rows[1]), offset),
          dot(as<Number>(rows[2]), offset)};
}

int true_side(const tracer::SpherePrimitive& s, Vec3 p) {
  return exact_sign([&]<class Number>(Number) {
    const Triple<Number> offset = as<Number>(p) - as<Number>(s.center);
    return Number(dot(offset, offset) - Number(s.radius) * Number(s.radius));
  });
}
int true_side(const tracer::EllipsoidPrimitive& e, Vec3 p) {
  return exact_sign([&]<class Number>(Number) {
    const Triple<Number> own = mapped<Number>(e.to_own, e.center, p);
    return Number(dot(own, own) - Number(1));
  });
}
int true_side(const tracer::PlanePrimitive& plane, Vec3 p) {
  return exact_sign([&]<class Number>(Number) {
    const Triple<Number> offset = as<Number>(p) - as<Number>(plane.point);
    return Number(dot(as<Number>(plane.normal), offset) - Number(plane.level));
  });
}
int true_side(const tracer::BoxPrimitive& box, Vec3 p) {
  int side = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto past = [&](bool upper) {
      return exact_sign([&]<class Number>(Number) {
        const Number place = box.aligned ? Number(p[axis]) : mapped<Number>(box.to_own, box.center, p)[axis];
        return upper ? Number(place - Number(box.hi[axis])) : Number(Number(box.lo[axis]) - place);
      });
    };
    side = std::max({side, past(false), past(true)});
  }
  return side;
}

}  // namespace

int true_side(const tracer::World& world, Vec3 p) {
  switch (world.primitives[0].kind) {
    case tracer::Kind::sphere: return true_side(world.spheres[0], p);
    case tracer::Kind::ellipsoid: return true_side(world.ellipsoids[0], p);
    case tracer::Kind::plane: return true_side(world.planes[0], p);
    case tracer::Kind::box: return true_side(world.boxes[0], p);
    case tracer::Kind::facet: break;
  }
  return 0;
}

}  // namespace lancer::stress::flat
