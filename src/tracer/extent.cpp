#include "tracer/extent.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "scene/corners.hpp"

namespace lancer::tracer {
namespace {

constexpr double k_margin = 1e-9;  // far above any rounding here
constexpr double k_surely = 1e-6;  // degrees

void add_sphere(Aabb& bounds, const scene::Sphere& sphere, const Affine& map) {
  const Vec3 center = map.point(sphere.center);
  const Vec3 reach{length(map.rows[0]), length(map.rows[1]), length(map.rows[2])};
  bounds.add(center + reach * sphere.radius);
  bounds.add(center - reach * sphere.radius);
}

double degrees_between(Vec3 a, Vec3 b) { return math::atan2_deg(length(cross(a, b)), dot(a, b)); }

}  // namespace

bool may_light_ball(const scene::Light& spot, Vec3 center, double radius) {
  const Vec3 way = center - spot.at;
  const double distance = length(way);
  if (!(distance > radius)) return true;
  const double apparent = math::asin_deg(std::min(1.0, radius / distance));
  return !(degrees_between(way, spot.direction) - apparent > spot.angle / 2 + k_surely);
}

Extent::Extent(const scene::Scene& scene) {
  for (const scene::Shape& shape : scene.shapes) add(scene, shape);
}

void Extent::add(const scene::Scene& scene, const scene::Shape& shape) {
  const Transform& transform = scene.transforms[shape.transform];
  if (shape.kind == scene::ShapeKind::sphere)
    add_sphere(bounded_, scene.spheres[shape.record], transform.to_world);
  if (shape.kind == scene::ShapeKind::plane) add_plane(scene.planes[shape.record], transform);
  scene::each_corner(scene, shape, [&](Vec3 p) { bounded_.add(p); });
}

void Extent::add_plane(const scene::Plane& plane, const Transform& transform) {
  const Vec3 on_it = plane.point + normalize(plane.normal) * plane.offset;
  planes_.push_back({transform.to_world.point(on_it), normalize(transform.normal_to_world(plane.normal))});
}

bool Extent::may_be_lit_by(const scene::Light& spot) const {
  if (bounded_.lo.x <= bounded_.hi.x) {
    const double radius = length(bounded_.hi - bounded_.lo) * (0.5 + k_margin);
    if (may_light_ball(spot, bounded_.center(), radius)) return true;
  }
  for (const Level& plane : planes_) {
    const double above = dot(spot.at - plane.point, plane.normal);
    const double rounding = k_margin * (max_abs(spot.at) + max_abs(plane.point));
    if (!(std::fabs(above) > rounding)) return true;
    const Vec3 down = above > 0 ? -plane.normal : plane.normal;
    if (!(degrees_between(spot.direction, down) - spot.angle / 2 > 90 + k_surely)) return true;
  }
  return false;
}

}  // namespace lancer::tracer
