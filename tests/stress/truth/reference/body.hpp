#pragma once
// The shapes of a scene as exact geometry: each kind in its own space, the ray brought there by the exact
// inverse of the map that the scene's doubles describe, so that distances along the ray stay what they are.

#include <array>
#include <cstdint>
#include <vector>

#include "real.hpp"
#include "scene/scene.hpp"

namespace lancer::reference {

/// p -> M p + t.
struct Map {
  std::array<Vector, 3> rows;
  Vector translation;

  static Map exact(const Affine& affine);
  Vector vector(const Vector& v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
  Vector point(const Vector& p) const { return vector(p) + translation; }
  /// M^T v.
  Vector transposed(const Vector& v) const { return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z; }
};
Map then(const Map& first, const Map& second);
Map inverse(const Map& map);

/// Where a line crosses a surface.
struct Root {
  Real t;
  bool entering = true;
  std::uint32_t face = 0;  // of a box: 2 axis, + 1 for the upper side; of a mesh: its facet
};

/// One shape, exactly.
class Body {
 public:
  Body(const scene::Scene& scene, std::uint32_t shape);

  std::uint32_t shape() const { return shape_; }
  bool encloses() const { return solid_; }
  /// A sphere, an ellipsoid or a box, which a line crosses twice or not at all.
  bool is_convex() const { return kind_ == scene::ShapeKind::sphere || kind_ == scene::ShapeKind::box; }

  /// All crossings of the line o + t d, for negative t too, in no order. Rims belong to facets.
  void roots(const Vector& origin, const Vector& direction, std::vector<Root>& out) const;
  /// Outward, unit length, flat.
  Vector normal(const Vector& p, std::uint32_t face) const;
  /// The smooth normal where the shape has one, else the flat one; outward as written.
  Vector smooth_normal(const Vector& p, std::uint32_t face) const;
  /// Of a facet: does it lie, from the point p of its rim, behind the plane through p with the normal `away`?
  bool ends_behind(std::uint32_t face, const Vector& p, const Vector& away) const;
  /// < 0 inside, 0 on the surface, > 0 outside; of what encloses something. Meshes by the solid angle that
  /// they subtend: never 0.
  Real side(const Vector& p) const;
  /// The point in the space before all transforms, where patterns live, and the size that the rounding of its
  /// coordinates is a part of.
  Vector own_point(const Vector& p) const { return pattern_space_.point(p); }
  Vector own_reach(const Vector& p) const;

 private:
  struct Triangle {
    Vector a, b, c, normal;  // the normal of any length
    std::array<Vector, 3> normals;
    bool smooth = false;
  };
  void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c);
  /// Is a mesh of many facets missed, as the ball around it is?
  bool passes_by(const Vector& o, const Vector& d) const;
  void sphere_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const;
  void plane_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const;
  void box_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const;
  void facet_roots(const Vector& o, const Vector& d, std::vector<Root>& out) const;

  std::uint32_t shape_;
  scene::ShapeKind kind_;
  bool solid_ = true;
  bool placed_ = false;  // is there a map but the identity?
  Map to_own_;           // world to the space of the kind
  Map to_world_;         // of the shape's transforms
  Map pattern_space_;    // world to the space before the shape's transforms
  Vector center_, normal_, lo_, hi_;
  Real radius_ = 0, level_ = 0;  // with the centre, of a mesh: of a ball around it
  std::vector<Triangle> triangles_;
};

}  // namespace lancer::reference
