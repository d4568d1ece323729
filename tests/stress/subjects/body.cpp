#include "stress/subjects/body.hpp"

#include <cmath>
#include <fmt/format.h>

#include "stress/subjects/mesh.hpp"
#include "stress/subjects/placement.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

Vec3 plane_normal() { return normalize(Vec3{0.3, 1, -0.2}); }

}  // namespace

std::string Cell::name() const {
  return fmt::format("scaled {:.0e}{}", scale, away > 0 ? ", moved 1e6" : "");
}

Affine Cell::map() const {
  Affine map;
  if (body == Body::ellipsoid || body == Body::box) map = scaling({1, 1.7, 0.6});
  if (body != Body::sphere && body != Body::plane) map = then(map, rotation(Vec3{1, 2, 3}, 50));
  return then(map, placement(1, away, scale));
}

void add_body(scene::Scene& scene, const Cell& cell, double grown) {
  using namespace tracer::test;
  const Affine map = cell.map();
  const double size = 1 + 2 * grown;
  switch (cell.body) {
    case Body::sphere: add_sphere(scene, map.translation, size * cell.scale); break;
    case Body::plane:
      add_plane(scene, map.translation + plane_normal() * (2 * grown * cell.scale), plane_normal());
      break;
    case Body::ellipsoid: add_sphere(scene, {}, size, {}, map); break;
    case Body::box: add_box(scene, {-size, -size, -size}, {size, size, size}, {}, map); break;
    case Body::mesh: {
      scene::Mesh mesh = icosphere(1);
      for (Vec3& p : mesh.points) p = p * size;
      add_mesh(scene, mesh, {}, map);
      break;
    }
  }
}

Line arriving(const Cell& cell, Random& random) {
  const Affine map = cell.map();
  Vec3 from = random.direction() * 3;
  if (cell.body == Body::plane && dot(from, plane_normal()) < 0) from = -from;
  return line_to(map.point(from), map.point(random.in_ball() * 0.5));
}

Vec3 leaving(Vec3 n, double sign, Random& random) {
  if (random.below(2) == 0) {
    const Vec3 d = random.direction();
    return dot(d, n) * sign > 0 ? d : -d;
  }
  const double slope = sign / std::pow(10.0, 1 + random.below(12));
  return normalize(random.across(n) + n * slope);
}

Vec3 inwards(const Cell& cell, Vec3 from, Vec3 n, Random& random) {
  const Vec3 aside = random.in_ball() * 0.3;
  if (cell.body == Body::plane) return normalize(aside - n);
  return normalize(cell.map().point(aside) - from);
}

}  // namespace lancer::stress::flat
