#include "body.hpp"

namespace lancer::reference {
namespace {

/// What is this small against its terms is 0: the numbers carry ten digits more.
const Real k_zero("1e-40");

}  // namespace

Map Map::exact(const Affine& affine) {
  Map map;
  for (std::size_t i = 0; i < 3; ++i) map.rows[i] = reference::exact(affine.rows[i]);
  map.translation = reference::exact(affine.translation) + reference::exact(affine.rest);
  return map;
}

Map then(const Map& first, const Map& second) {
  Map out;
  for (std::size_t i = 0; i < 3; ++i) out.rows[i] = first.transposed(second.rows[i]);
  out.translation = second.point(first.translation);
  return out;
}

Map inverse(const Map& map) {
  const auto& m = map.rows;
  const Vector a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
  const Real det = dot(m[0], a);
  Map out;
  out.rows[0] = Vector{a.x, b.x, c.x} / det;
  out.rows[1] = Vector{a.y, b.y, c.y} / det;
  out.rows[2] = Vector{a.z, b.z, c.z} / det;
  out.translation = -out.vector(map.translation);
  return out;
}

Body::Body(const scene::Scene& scene, std::uint32_t shape) : shape_(shape), kind_(scene.shapes[shape].kind) {
  const scene::Shape& s = scene.shapes[shape];
  Map to_world = Map::exact(scene.transforms[s.transform].to_world);
  placed_ = s.transform != 0;
  to_world_ = to_world;
  pattern_space_ = inverse(to_world);
  to_own_ = pattern_space_;
  switch (kind_) {
    case scene::ShapeKind::sphere:
      center_ = exact(scene.spheres[s.record].center);
      radius_ = scene.spheres[s.record].radius;
      break;
    case scene::ShapeKind::plane: {
      const scene::Plane& plane = scene.planes[s.record];
      normal_ = exact(plane.normal);
      level_ = dot(exact(plane.point), normal_) + Real(plane.offset) * length(normal_);
      break;
    }
    case scene::ShapeKind::box: {
      const scene::Box& box = scene.boxes[s.record];
      lo_ = exact(box.lo);
      hi_ = exact(box.hi);
      if (box.frame != 0) {
        placed_ = true;
        to_own_ = inverse(then(Map::exact(scene.transforms[box.frame].to_world), to_world));
      }
      break;
    }
    case scene::ShapeKind::facet: {
      const scene::Facet& facet = scene.facets[s.record];
      solid_ = false;
      add_triangle(facet.a, facet.b, facet.c);
      if (facet.normals != scene::k_none) {
        triangles_[0].smooth = true;
        for (std::size_t i = 0; i < 3; ++i)
          triangles_[0].normals[i] = exact(scene.facet_normals[facet.normals][i]);
      }
      break;
    }
    case scene::ShapeKind::mesh: {
      const scene::Mesh& mesh = scene.meshes[s.record];
      solid_ = mesh.solid;
      for (const auto& face : mesh.faces) {
        add_triangle(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]);
        if (mesh.normals.empty()) continue;
        triangles_.back().smooth = true;
        for (std::size_t i = 0; i < 3; ++i) triangles_.back().normals[i] = exact(mesh.normals[face[i]]);
      }
      for (const Vec3& p : mesh.points) center_ = center_ + exact(p) / Real(mesh.points.size());
      for (const Vec3& p : mesh.points) {
        const Real reach = length(exact(p) - center_) * Real("1.000001");
        if (reach > radius_) radius_ = reach;
      }
      break;
    }
  }
}

void Body::add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  Triangle t;
  t.a = exact(a);
  t.b = exact(b);
  t.c = exact(c);
  t.normal = cross(t.b - t.a, t.c - t.a);
  triangles_.push_back(t);
}

void Body::roots(const Vector& origin, const Vector& direction, std::vector<Root>& out) const {
  out.clear();
  const Vector o = placed_ ? to_own_.point(origin) : origin;
  const Vector d = placed_ ? to_own_.vector(direction) : direction;
  if (passes_by(o, d)) return;
  switch (kind_) {
    case scene::ShapeKind::sphere: return sphere_roots(o, d, out);
    case scene::ShapeKind::plane: return plane_roots(o, d, out);
    case scene::ShapeKind::box: return box_roots(o, d, out);
    case scene::ShapeKind::facet:
    case scene::ShapeKind::mesh: return facet_roots(o, d, out);
  }
}

bool Body::passes_by(const Vector& o, const Vector& d) const {
  if (triangles_.size() < 4) return false;
  const Vector off = cross(o - center_, d);
  return dot(off, off) > radius_ * radius_ * dot(d, d);
}

void Body::sphere_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const {
  const Vector f = o - center_;
  const Real a = dot(d, d), b = dot(f, d), c = dot(f, f) - radius_ * radius_;
  const Real disc = b * b - a * c;
  if (disc <= 0) return;
  const Real q = sqrt(disc);
  out.push_back({(-b - q) / a, true, 0});
  out.push_back({(-b + q) / a, false, 0});
}

void Body::plane_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const {
  const Real slope = dot(normal_, d);
  if (slope == 0) return;
  out.push_back({(level_ - dot(normal_, o)) / slope, slope < 0, 0});
}

void Body::box_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const {
  Root in{0, true, 0}, away{0, false, 0};
  bool first = true;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      if (o[axis] <= lo_[axis] || o[axis] >= hi_[axis]) return;
      continue;
    }
    Real near = (lo_[axis] - o[axis]) / d[axis], far = (hi_[axis] - o[axis]) / d[axis];
    const bool upward = d[axis] > 0;
    if (!upward) std::swap(near, far);
    const auto face = static_cast<std::uint32_t>(2 * axis);
    if (first || near > in.t) in = {near, true, face + (upward ? 0U : 1U)};
    if (first || far < away.t) away = {far, false, face + (upward ? 1U : 0U)};
    first = false;
  }
  if (in.t > away.t) return;
  out.push_back(in);
  out.push_back(away);
}

void Body::facet_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const {
  const Real steps = k_zero * largest(d);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const Triangle& f = triangles_[i];
    const Real slope = dot(f.normal, d);
    if (slope == 0) continue;
    const Vector a = f.a - o, b = f.b - o, c = f.c - o;
    // Six times the volumes over the edges: of one sign where the line passes within.
    const auto over = [&](const Vector& p, const Vector& q) {
      const Vector normal = cross(p, q);
      const Real volume = dot(d, normal);
      return abs(volume) <= steps * largest(p) * largest(q) ? Real(0) : volume;
    };
    const Real u = over(b, c), v = over(c, a), w = over(a, b);
    const bool positive = u >= 0 && v >= 0 && w >= 0, negative = u <= 0 && v <= 0 && w <= 0;
    if (positive == negative) continue;  // both: too narrow a facet to be seen
    out.push_back({dot(f.normal, a) / slope, slope < 0, i});
  }
}

Vector Body::normal(const Vector& p, std::uint32_t face) const {
  Vector own;
  switch (kind_) {
    case scene::ShapeKind::sphere: own = (placed_ ? to_own_.point(p) : p) - center_; break;
    case scene::ShapeKind::plane: own = normal_; break;
    case scene::ShapeKind::box: own[static_cast<int>(face / 2)] = face % 2 == 1 ? 1 : -1; break;
    case scene::ShapeKind::facet:
    case scene::ShapeKind::mesh: own = triangles_[face].normal; break;
  }
  return unit(placed_ ? to_own_.transposed(own) : own);
}

Vector Body::smooth_normal(const Vector& p, std::uint32_t face) const {
  if (triangles_.empty() || !triangles_[face].smooth) return normal(p, face);
  const Triangle& f = triangles_[face];
  const Vector own = placed_ ? to_own_.point(p) : p;
  const Real u = dot(cross(f.b - own, f.c - own), f.normal), v = dot(cross(f.c - own, f.a - own), f.normal),
             w = dot(cross(f.a - own, f.b - own), f.normal);
  const Vector n = f.normals[0] * u + f.normals[1] * v + f.normals[2] * w;
  if (largest(n) == 0) return normal(p, face);
  return unit(placed_ ? to_own_.transposed(n) : n);
}

bool Body::ends_behind(std::uint32_t face, const Vector& p, const Vector& away) const {
  if (triangles_.empty()) return false;
  const Triangle& f = triangles_[face];
  const Vector own = placed_ ? to_own_.point(p) : p;
  // Directions to the world: by the inverse of what brings them here.
  const Vector ahead = (f.a - own) + (f.b - own) + (f.c - own);
  return dot(away, to_world_.vector(ahead)) < -Real("1e-12") * largest(p);
}

Real Body::side(const Vector& p) const {
  const Vector own = placed_ ? to_own_.point(p) : p;
  switch (kind_) {
    case scene::ShapeKind::sphere: {
      const Vector f = own - center_;
      return dot(f, f) - radius_ * radius_;
    }
    case scene::ShapeKind::plane: return dot(own, normal_) - level_;
    case scene::ShapeKind::box: {
      Real worst = lo_.x - own.x;
      for (int axis = 0; axis < 3; ++axis) {
        for (const Real& beyond : {Real(lo_[axis] - own[axis]), Real(own[axis] - hi_[axis])}) {
          if (beyond > worst) worst = beyond;
        }
      }
      return worst;
    }
    case scene::ShapeKind::facet: break;
    case scene::ShapeKind::mesh: {
      // A. van Oosterom, J. Strackee, "The solid angle of a plane triangle" (1983).
      Real sum = 0;
      for (const Triangle& f : triangles_) {
        const Vector a = f.a - own, b = f.b - own, c = f.c - own;
        const Real x = length(a), y = length(b), z = length(c);
        sum += atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
      }
      return Real(1.5) - abs(sum);  // the sum is 2 pi inside, 0 outside
    }
  }
  return 1;
}

Vector Body::own_reach(const Vector& p) const {
  const Real size = largest(p);
  Vector reach;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector& row = pattern_space_.rows[static_cast<std::size_t>(axis)];
    reach[axis] = (abs(row.x) + abs(row.y) + abs(row.z)) * size + abs(pattern_space_.translation[axis]);
  }
  return reach;
}

}  // namespace lancer::reference
