#include "tracer/prepare.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/shapes/linear_map.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {
namespace {

/// How far rounding may have moved p: coordinates as written are taken to be off by an ulp, so that surfaces
/// that coincide but for the rounding of their numbers count as coincident; mapped ones by that of the map
/// too.
double image_error(const Affine& map, Vec3 p) {
  if (is_identity(map)) return 2 * k_u * max_abs(p);
  return 8 * k_u * max_abs(apply_abs(map.rows, p) + abs(map.translation));
}

/// Where the map puts a point of the shape's own space, in that of the world; rounded once.
Place placed(const World& world, const Affine& map, const Place& own) {
  return (is_identity(map) ? own : map.place(own)).from(world.origin);
}
Vec3 placed(const World& world, const Affine& map, Vec3 own) { return placed(world, map, Place{own, {}}).at; }

/// Does the map keep angles, within rounding? `factor` is by how much it scales.
bool is_similarity(const Affine& map, double& factor) {
  int exponent = 0;
  const Rows m = near_one(map.rows, exponent);
  const double xx = dot(m[0], m[0]), yy = dot(m[1], m[1]), zz = dot(m[2], m[2]);
  const double tolerance = 64 * k_u * xx;
  factor = std::scalbn(std::sqrt(xx), exponent);
  return std::fabs(xx - yy) <= tolerance && std::fabs(xx - zz) <= tolerance &&
         std::fabs(dot(m[0], m[1])) <= tolerance && std::fabs(dot(m[1], m[2])) <= tolerance &&
         std::fabs(dot(m[2], m[0])) <= tolerance;
}

/// Does the map take the axes to axes?
bool keeps_axes(const Affine& map) {
  return std::all_of(map.rows.begin(), map.rows.end(), [](Vec3 row) {
    return (row.x != 0 ? 1 : 0) + (row.y != 0 ? 1 : 0) + (row.z != 0 ? 1 : 0) == 1;
  });
}

template <class T>
void append(World& world, std::vector<T>& records, const T& record, Kind kind, std::uint32_t shape) {
  world.primitives.push_back({kind, static_cast<std::uint32_t>(records.size()), shape});
  records.push_back(record);
}

void add_sphere(World& world, std::uint32_t shape, const scene::Sphere& sphere, const Transform& transform) {
  const Affine& map = transform.to_world;
  const Vec3 center = placed(world, map, sphere.center);
  const double reach = max_abs(apply_abs(map.rows, {sphere.radius, sphere.radius, sphere.radius}));
  const double slack = image_error(map, sphere.center) + (is_identity(map) ? 2 : 8) * k_u * reach;
  double factor = 1;
  if (is_identity(map) || is_similarity(map, factor)) {
    append(world, world.spheres, SpherePrimitive{center, sphere.radius * factor, slack}, Kind::sphere, shape);
    return;
  }
  EllipsoidPrimitive ellipsoid{center, {}, map.rows, slack, 0, 0};
  for (Vec3& row : ellipsoid.to_world) row = row * sphere.radius;
  ellipsoid.to_own = accurate_inverse(ellipsoid.to_world);
  for (const Vec3 row : ellipsoid.to_own) {
    ellipsoid.reach += sum_abs(row);
    ellipsoid.own_slack = std::fmax(ellipsoid.own_slack, sum_abs(row) * slack);
  }
  append(world, world.ellipsoids, ellipsoid, Kind::ellipsoid, shape);
}

/// The axis that the normal lies along, where the level is 0; else -1.
int axis_across(Vec3 normal, double level) {
  for (int axis = 0; axis < 3; ++axis) {
    if (level == 0 && normal[(axis + 1) % 3] == 0 && normal[(axis + 2) % 3] == 0) return axis;
  }
  return -1;
}

void add_plane(World& world, std::uint32_t shape, const scene::Plane& plane, const Transform& transform) {
  const Affine& map = transform.to_world;
  const bool turned = !is_identity(map);
  Vec3 n = plane.normal;
  double level = plane.offset * length(n);
  if (turned) n = transform.normal_to_world(n);
  const int exponent = std::ilogb(max_abs(n));
  n = times_power_of_two(n, -exponent);
  level = std::scalbn(level, -exponent);
  const Place at = placed(world, map, Place{plane.point, {}});
  const double slack = image_error(map, plane.point) + 4 * k_u * std::fabs(level) / length(n);
  // A normal along an axis that no transform turned is no rounded one.
  const bool along_axis = axis_across(n, 0) >= 0;
  const double normal_error = (turned ? 16 : along_axis ? 0 : 2) * k_u;
  // One across an axis is a coordinate, rounded like others.
  if (!along_axis) level += dot(n, at.rest);
  const PlanePrimitive out{at.at, n, level, unit(n), sum_abs(n), slack, normal_error, axis_across(n, level)};
  append(world, world.planes, out, Kind::plane, shape);
}

Place middle(Vec3 a, Vec3 b) {
  Place out;
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDouble sum = two_sum(a[axis] * 0.5, b[axis] * 0.5);
    out.at[axis] = sum.hi;
    out.rest[axis] = sum.lo;
  }
  return out;
}

void add_box(World& world, std::uint32_t shape, const scene::Box& box, const Transform& transform) {
  const Transform& frame = world.scene->transforms[box.frame];
  const Affine map = box.frame == 0 ? transform.to_world : then(frame.to_world, transform.to_world);
  BoxPrimitive out;
  const Vec3 corner{std::fmax(std::fabs(box.lo.x), std::fabs(box.hi.x)),
                    std::fmax(std::fabs(box.lo.y), std::fabs(box.hi.y)),
                    std::fmax(std::fabs(box.lo.z), std::fabs(box.hi.z))};
  out.slack = image_error(map, corner);
  if (keeps_axes(map)) {
    Aabb extent;
    extent.add(placed(world, map, box.lo));
    extent.add(placed(world, map, box.hi));
    out.lo = extent.lo;
    out.hi = extent.hi;
  } else {
    out.aligned = false;
    out.center = placed(world, map, middle(box.lo, box.hi)).at;
    const Vec3 half = box.hi * 0.5 - box.lo * 0.5;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 row = map.rows[i];
      out.to_world[i] = {row.x * half.x, row.y * half.y, row.z * half.z};
    }
    out.to_own = accurate_inverse(out.to_world);
    for (std::size_t i = 0; i < 3; ++i) {
      out.normals[i] = unit(out.to_own[i]);
      out.reach[static_cast<int>(i)] = sum_abs(out.to_own[i]);
    }
  }
  append(world, world.boxes, out, Kind::box, shape);
}

void add_facet(World& world, std::uint32_t shape, const std::array<Vec3, 3>& corners, std::uint32_t face,
               const Affine& map) {
  FacetPrimitive facet;
  facet.a = placed(world, map, corners[0]);
  facet.b = placed(world, map, corners[1]);
  facet.c = placed(world, map, corners[2]);
  facet.flipped = determinant(map) < 0;
  facet.face = face;
  for (const Vec3 corner : corners) facet.slack = std::fmax(facet.slack, image_error(map, corner));
  facet.normal = normal_of_corners(facet);
  if (max_abs(facet.normal) > 0) append(world, world.facets, facet, Kind::facet, shape);
}

void add_mesh(World& world, std::uint32_t shape, const scene::Mesh& mesh, const Affine& map) {
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const auto& [a, b, c] = mesh.faces[face];
    add_facet(world, shape, {mesh.points[a], mesh.points[b], mesh.points[c]}, face, map);
  }
}

}  // namespace

void add_primitives(World& world, std::uint32_t shape) {
  const scene::Scene& scene = *world.scene;
  const scene::Shape& s = scene.shapes[shape];
  const Transform& transform = scene.transforms[s.transform];
  switch (s.kind) {
    case scene::ShapeKind::sphere: add_sphere(world, shape, scene.spheres[s.record], transform); break;
    case scene::ShapeKind::plane: add_plane(world, shape, scene.planes[s.record], transform); break;
    case scene::ShapeKind::box: add_box(world, shape, scene.boxes[s.record], transform); break;
    case scene::ShapeKind::facet: {
      const scene::Facet& facet = scene.facets[s.record];
      add_facet(world, shape, {facet.a, facet.b, facet.c}, 0, transform.to_world);
      break;
    }
    case scene::ShapeKind::mesh: add_mesh(world, shape, scene.meshes[s.record], transform.to_world); break;
  }
}

}  // namespace lancer::tracer
