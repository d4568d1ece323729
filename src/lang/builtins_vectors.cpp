// Functions of vectors.

#include <array>
#include <cmath>

#include "base/transform.hpp"
#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"
#include "lang/geometry_checks.hpp"

namespace lancer::lang {
namespace {

/// `v` with as many components as `like`.
Value as_many(const Value& like, Vec3 v) { return like.dimension() == 2 ? Value(v.x, v.y) : Value(v); }

Value dot_of(const Arguments& a) {
  a.same_dimension(0, 1);
  return dot(a[0].vec3(), a[1].vec3());
}

Value cross_of(const Arguments& a) { return cross(a.vec3(0), a.vec3(1)); }

Value length_of(const Arguments& a) { return length(a.vector(0).vec3()); }

/// Of any number of components, not all 0.
Vec3 nonzero(const Arguments& a, std::size_t i) {
  const Value& v = a.vector(i);
  if (max_abs(v.vec3()) == 0) {
    a.refuse(Code::degenerate, i,
             "`" + std::string(a.id()) + "` wants a vector that is not zero; this one is " +
                 (v.dimension() == 2 ? "<0, 0>" : "<0, 0, 0>"));
  }
  return v.vec3();
}

Value normalize_of(const Arguments& a) { return as_many(a[0], normalize(nonzero(a, 0))); }

Value distance_of(const Arguments& a) {
  a.same_dimension(0, 1);
  return length(a[0].vec3() - a[1].vec3());
}

Value hypot_of(const Arguments& a) {
  const double c = a.size() == 3 ? a.number(2) : 0;
  return length(Vec3{a.number(0), a.number(1), c});
}

/// v - 2 (v.n / n.n) n, for n of any length.
Value reflect_of(const Arguments& a) {
  a.same_dimension(0, 1);
  const Vec3 v = a[0].vec3();
  const Vec3 n = scaled_to_one(nonzero(a, 1));
  return as_many(a[0], v - n * (2 * (dot(v, n) / dot(n, n))));
}

Value rotate_about_of(const Arguments& a) {
  const Vec3 v = a.vec3(0);
  return rotation(a.direction(1, "an axis"), a.number(2)).vector(v);
}

constexpr std::array k_table{
    BuiltinInfo{"dot", "dot(a, b)", "the scalar product", 2, 2, dot_of},
    BuiltinInfo{"cross", "cross(a, b)", "the vector product", 2, 2, cross_of},
    BuiltinInfo{"length", "length(v)", "the length of a vector", 1, 1, length_of},
    BuiltinInfo{"normalize", "normalize(v)", "the vector of length 1 in the same direction", 1, 1,
                normalize_of},
    BuiltinInfo{"distance", "distance(a, b)", "the distance of two points", 2, 2, distance_of},
    BuiltinInfo{"hypot", "hypot(a, b[, c])", "the square root of the sum of the squares", 2, 3, hypot_of},
    BuiltinInfo{"reflect", "reflect(v, n)", "v mirrored at the plane with the normal n", 2, 2, reflect_of},
    BuiltinInfo{"rotate_about", "rotate_about(v, axis, angle)",
                "v turned about an axis by an angle in degrees", 3, 3, rotate_about_of},
};

}  // namespace

std::span<const BuiltinInfo> vector_builtins() { return k_table; }

}  // namespace lancer::lang
