// Spheres, planes, cubes, boxes and facets.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "base/number.hpp"
#include "lang/build_parts.hpp"
#include "lang/geometry_checks.hpp"
#include "lang/keywords.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;

/// Beyond it, a face given by three points counts as no square: well above rounding, well below what is seen.
constexpr double k_square_tolerance = 1e-9;

std::array<Vec3, 3> read_three_points(const Slot& slot) {
  const std::array<Vec3, 3> p{read_point(slot[0]), read_point(slot[1]), read_point(slot[2])};
  if (are_on_a_line(p[0], p[1], p[2])) {
    throw ScriptError(Code::degenerate, slot.span(),
                      fmt::format("the points of a {} lie on a line", kind_info(slot.kind).id),
                      fmt::format("they are {}, {} and {}", to_text(p[0]), to_text(p[1]), to_text(p[2])));
  }
  return p;
}

/// Sizes near the end of the range of numbers may reach past it.
void check_reach(const BlockReader& reader, Vec3 lo, Vec3 hi) {
  if (is_finite(lo) && is_finite(hi)) return;
  throw ScriptError(Code::not_finite, reader.kind_span(),
                    fmt::format("this {} reaches beyond the range of numbers", kind_info(reader.kind()).id));
}

Record build_sphere(const BlockReader& reader) {
  scene::Sphere sphere;
  sphere.center = read_point(reader.need("center").one());
  sphere.radius = read_positive(reader.need("radius").one());
  const Vec3 reach{sphere.radius, sphere.radius, sphere.radius};
  check_reach(reader, sphere.center - reach, sphere.center + reach);
  return sphere;
}

Record build_plane(const BlockReader& reader) {
  if (const auto points = reader.find("points")) {
    const auto p = read_three_points(*points);
    return scene::Plane{p[0], normal_of(p[0], p[1], p[2]), 0};
  }
  scene::Plane plane;
  if (const auto distance = reader.find(k_plane_distance)) {
    plane.normal = read_direction(reader.need("normal").one());
    plane.offset = read_number(distance->one());
    return plane;
  }
  plane.point = read_point(reader.need("point").one());
  plane.normal = read_direction(reader.need("normal").one());
  return plane;
}

void warn_unless_square(const Slot& slot, Vec3 e1, Vec3 e2, std::vector<Diagnostic>& warnings) {
  const double a = length(e1), b = length(e2);
  const double cosine = dot(normalize(e1), normalize(e2));
  std::string what;
  if (std::fabs(a - b) > k_square_tolerance * std::max(a, b)) {
    what = fmt::format("its sides are {} and {} long", lancer::to_text(a), lancer::to_text(b));
  } else if (std::fabs(cosine) > k_square_tolerance) {
    what = "its sides are not at right angles";
  } else {
    return;
  }
  warnings.push_back(warning(Code::not_square, slot.span(), "the face of this cube is no square", what));
}

/// The unit cube in a frame with the edges of the face and the extrusion as its columns.
Record build_cube_on_face(const Slot& slot, std::vector<Diagnostic>& warnings) {
  const auto p = read_three_points(slot);
  const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
  const Vec3 e3 = normalize(normal_of(p[0], p[1], p[2])) * length(e1);
  const Affine frame{{Vec3{e1.x, e2.x, e3.x}, Vec3{e1.y, e2.y, e3.y}, Vec3{e1.z, e2.z, e3.z}}, p[0]};
  if (!is_finite(frame) || !inverse(frame)) {
    throw ScriptError(Code::not_finite, slot.span(), "this cube reaches beyond the range of numbers");
  }
  warn_unless_square(slot, e1, e2, warnings);
  return BoxRecord{{0, 0, 0}, {1, 1, 1}, frame};
}

Record build_cube(const BlockReader& reader, std::vector<Diagnostic>& warnings) {
  if (const auto points = reader.find("points")) return build_cube_on_face(*points, warnings);
  const Vec3 center = read_point(reader.need("center").one());
  const Argument side = reader.need("side").one();
  const double half = read_positive(side) / 2;
  const BoxRecord box{center - Vec3{half, half, half}, center + Vec3{half, half, half}, {}};
  check_reach(reader, box.lo, box.hi);
  if (box.lo.x == box.hi.x || box.lo.y == box.hi.y || box.lo.z == box.hi.z) {
    throw ScriptError(Code::degenerate, side.span,
                      fmt::format("a cube's side of {} is lost beside its center {}",
                                  lancer::to_text(2 * half), to_text(center)),
                      "put the cube at <0, 0, 0> and `translate` what it belongs to");
  }
  return box;
}

Record build_box(const BlockReader& reader) {
  const Slot corners = reader.need("corners");
  const Vec3 a = read_point(corners[0]), b = read_point(corners[1]);
  for (int axis = 0; axis < 3; ++axis) {
    if (a[axis] != b[axis]) continue;
    throw ScriptError(Code::degenerate, corners[1].span,
                      fmt::format("a box is not flat; its corners have the same {}, {}", "xyz"[axis],
                                  lancer::to_text(a[axis])),
                      "something flat is made of `facet { a, b, c }`");
  }
  const BoxRecord box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                      {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)},
                      {}};
  check_reach(reader, box.hi - box.lo, box.hi);
  return box;
}

Record build_facet(const BlockReader& reader) {
  const auto p = read_three_points(reader.need("points"));
  FacetRecord facet{p[0], p[1], p[2], {}};
  if (const auto normals = reader.find("normals")) {
    facet.normals.emplace();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 n = read_point((*normals)[i]);
      if (n == Vec3{}) {
        throw ScriptError(Code::degenerate, (*normals)[i].span, "a normal is not zero",
                          "leave `normals` out for a flat facet");
      }
      (*facet.normals)[i] = normalize(n);
    }
  }
  return facet;
}

}  // namespace

Record build_shape(const BlockReader& reader, std::vector<Diagnostic>& warnings) {
  switch (reader.kind()) {
    case Kind::sphere: return build_sphere(reader);
    case Kind::plane: return build_plane(reader);
    case Kind::cube: return build_cube(reader, warnings);
    case Kind::box: return build_box(reader);
    default: return build_facet(reader);
  }
}

}  // namespace lancer::lang
