#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/math.hpp"
#include "scene/corners.hpp"
#include "scene/scene.hpp"

namespace lancer::scene {
namespace {

/// A ball that is sure to hold a shape.
struct Ball {
  Vec3 center;
  double radius = 0;
};

/// The box [lo, hi] of the points added.
struct Extent {
  Vec3 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::infinity()};
  Vec3 hi = -lo;

  void add(Vec3 p) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }
  bool empty() const { return lo.x > hi.x; }
  Vec3 center() const { return lo * 0.5 + hi * 0.5; }
};

/// The root of the largest row sum of |a_i . a_j|: no smaller than the root of the Gram matrix' largest
/// eigenvalue.
double gram_bound(Vec3 a, Vec3 b, Vec3 c) {
  const double ab = std::fabs(dot(a, b)), bc = std::fabs(dot(b, c)), ca = std::fabs(dot(c, a));
  return std::sqrt(std::max({dot(a, a) + ab + ca, dot(b, b) + ab + bc, dot(c, c) + bc + ca}));
}

/// By how much, at most, the map lengthens a vector; exact for scalings, rotations and either after the
/// other.
double stretch(const Affine& map) {
  const double by_rows = gram_bound(map.rows[0], map.rows[1], map.rows[2]);
  return std::min(by_rows, gram_bound(map.vector({1, 0, 0}), map.vector({0, 1, 0}), map.vector({0, 0, 1})));
}

/// Planes have none.
std::optional<Ball> ball_around(const Scene& scene, const Shape& shape) {
  if (shape.kind == ShapeKind::sphere) {
    const Affine& map = scene.transforms[shape.transform].to_world;
    const Sphere& sphere = scene.spheres[shape.record];
    return Ball{map.point(sphere.center), sphere.radius * stretch(map)};
  }
  Extent corners;
  each_corner(scene, shape, [&](Vec3 p) { corners.add(p); });
  if (corners.empty()) return std::nullopt;
  return Ball{corners.center(), length(corners.hi - corners.lo) / 2};
}

/// The ball that the view frames: around all shapes with bounds; else around the planes' points; else the
/// unit ball.
Ball subject(const Scene& scene) {
  Extent extent;
  for (const Shape& shape : scene.shapes) {
    if (const auto ball = ball_around(scene, shape)) {
      const Vec3 half{ball->radius, ball->radius, ball->radius};
      extent.add(ball->center - half);
      extent.add(ball->center + half);
    }
  }
  if (extent.empty()) {
    for (const Shape& shape : scene.shapes) {
      if (shape.kind != ShapeKind::plane) continue;
      const Plane& plane = scene.planes[shape.record];
      extent.add(scene.transforms[shape.transform].to_world.point(plane.point +
                                                                  normalize(plane.normal) * plane.offset));
    }
    const Vec3 center = extent.empty() ? Vec3{} : extent.center();
    const double radius = extent.empty() ? 0 : length(extent.hi - extent.lo) / 2;
    return {center, radius > 0 ? radius : 1};
  }
  Ball all{extent.center(), 0};
  for (const Shape& shape : scene.shapes) {
    if (const auto ball = ball_around(scene, shape)) {
      all.radius = std::max(all.radius, length(ball->center - all.center) + ball->radius);
    }
  }
  return all;
}

}  // namespace

View automatic_view(const Scene& scene) {
  constexpr double k_margin = 1.05;
  const Vec3 from_front = normalize({0.4, 0.35, 1});
  const Ball ball = subject(scene);
  View view;
  // The ball touches the narrower, vertical opening: sin of half of it is radius over distance.
  const double slope = math::tan_deg(view.fov / 2) * view.rows / view.columns;
  const double distance = k_margin * ball.radius * std::sqrt(1 + slope * slope) / slope;
  view.eye = ball.center + from_front * distance;
  view.look = -from_front;
  return view;
}

}  // namespace lancer::scene
