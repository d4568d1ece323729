// Meshes whose points and faces stand in the script.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/number.hpp"
#include "lang/build_parts.hpp"
#include "lang/geometry_checks.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using Face = std::vector<std::uint32_t>;

/// The place of element `i` where the list was written out, else that of the whole.
const ast::Expr* element(const ast::Expr* list, std::size_t i) {
  if (list == nullptr || list->kind != ast::ExprKind::list) return nullptr;
  const auto items = ast::as<ast::List>(*list).items;
  return i < items.size() ? items[i] : nullptr;
}
Span place(const ast::Expr* expr, Span otherwise) { return expr != nullptr ? expr->span : otherwise; }

[[noreturn]] void refuse_list(const Slot& slot, std::string_view wanted, std::string help) {
  throw ScriptError(Code::wrong_type, slot.span(),
                    fmt::format("`{}` takes {}; this is {}", slot.id, wanted, found_text(slot.values[0])),
                    std::move(help));
}

std::vector<Vec3> read_points(const Slot& slot, Meter& meter) {
  const Value& list = slot.values[0];
  if (!list.is_list_like()) refuse_list(slot, "a list of points", "write [<0, 0, 0>, <1, 0, 0>, <0, 1, 0>]");
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < list.length(); ++i) {
    meter.charge(1, slot.span());
    const Value item = list.item(i);
    if (!item.is(Type::vector) || item.dimension() != 3) {
      throw ScriptError(
          Code::wrong_type, place(element(slot.places[0], i), slot.span()),
          fmt::format("a mesh's points are vectors of 3; number {} is {}", i, found_text(item)));
    }
    out.push_back(item.vec3());
  }
  return out;
}

std::uint32_t read_index(const Value& value, std::size_t points, Span span) {
  if (!value.is(Type::number)) {
    throw ScriptError(Code::wrong_type, span,
                      fmt::format("a mesh's faces are lists of indices; this is {}", with_article(value)));
  }
  const double v = value.number();
  if (!(v >= 0 && v < static_cast<double>(points)) || v != std::trunc(v)) {
    const std::string index = lancer::to_text(v);
    throw ScriptError(Code::bad_mesh, span,
                      v != std::trunc(v)
                          ? fmt::format("an index is whole; this one is {}", index)
                          : fmt::format("the index {} is out of range: there {} {} point{}", index,
                                        points == 1 ? "is" : "are", points, points == 1 ? "" : "s"),
                      "the points of a mesh count from 0");
  }
  return static_cast<std::uint32_t>(v);
}

Face read_face(const Value& value, const ast::Expr* written, std::size_t points, Span span, Meter& meter) {
  if (!value.is_list_like()) {
    throw ScriptError(Code::wrong_type, place(written, span),
                      fmt::format("a mesh's face is a list of indices; this is {}", with_article(value)));
  }
  if (value.length() < 3) {
    throw ScriptError(
        Code::bad_mesh, place(written, span),
        fmt::format("a mesh's face has three or more indices; this one has {}", value.length()));
  }
  Face out;
  for (std::size_t i = 0; i < value.length(); ++i) {
    meter.charge(1, span);
    out.push_back(read_index(value.item(i), points, place(element(written, i), place(written, span))));
  }
  return out;
}

std::vector<Face> read_faces(const Slot& slot, std::size_t points, Meter& meter) {
  const Value& list = slot.values[0];
  if (!list.is_list_like()) refuse_list(slot, "a list of faces", "write [[0, 1, 2], [0, 2, 3]]");
  if (list.length() == 0)
    throw ScriptError(Code::bad_mesh, slot.span(), "a mesh has at least one face; this one has none");
  std::vector<Face> out;
  for (std::size_t i = 0; i < list.length(); ++i) {
    out.push_back(read_face(list.item(i), element(slot.places[0], i), points, slot.span(), meter));
  }
  return out;
}

/// Polygons become fans around their first point; parts that name a point twice have no area and are left
/// out.
void cut_into_facets(const std::vector<Face>& faces, scene::Mesh& mesh) {
  for (const Face& f : faces) {
    for (std::size_t i = 2; i < f.size(); ++i) {
      if (f[0] != f[i - 1] && f[i - 1] != f[i] && f[i] != f[0]) mesh.faces.push_back({f[0], f[i - 1], f[i]});
    }
  }
}

/// Points moved and scaled so that products of three neither overflow nor vanish.
std::vector<Vec3> scaled_points(const std::vector<Vec3>& points) {
  Vec3 lo = points[0] * 0.5, hi = lo;
  for (const Vec3 p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      lo[axis] = std::min(lo[axis], p[axis] * 0.5);
      hi[axis] = std::max(hi[axis], p[axis] * 0.5);
    }
  }
  const double extent = max_abs(hi - lo);
  const int exponent = extent == 0 ? 0 : -std::ilogb(extent);
  std::vector<Vec3> out;
  for (const Vec3 p : points) out.push_back(times_power_of_two(p * 0.5 - lo, exponent));
  return out;
}

/// Twice the area of a polygon times its normal, by Newell's sum.
Vec3 area_vector(const Face& face, const std::vector<Vec3>& points) {
  Vec3 sum;
  const Vec3 first = points[face[0]];
  for (std::size_t i = 2; i < face.size(); ++i)
    sum = sum + cross(points[face[i - 1]] - first, points[face[i]] - first);
  return sum;
}

/// The area-weighted mean of the faces that share each point. Where these cancel out, the first face decides.
std::vector<Vec3> smooth_normals(const std::vector<Face>& faces, const std::vector<Vec3>& points) {
  const std::vector<Vec3> scaled = scaled_points(points);
  std::vector<Vec3> sums(points.size()), firsts(points.size(), Vec3{});
  for (const Face& face : faces) {
    const Vec3 area = area_vector(face, scaled);
    Face corners = face;
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const std::uint32_t i : corners) {
      sums[i] = sums[i] + area;
      if (firsts[i] == Vec3{}) firsts[i] = area;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i] == Vec3{}) sums[i] = firsts[i] == Vec3{} ? Vec3{0, 1, 0} : firsts[i];
    sums[i] = normalize(sums[i]);
  }
  return sums;
}

/// Facets without area are never hit.
void drop_flat_facets(scene::Mesh& mesh) {
  std::erase_if(mesh.faces, [&](const auto& f) {
    return normal_of(mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]) == Vec3{};
  });
}

}  // namespace

Record build_mesh(const BlockReader& reader, Meter& meter) {
  if (const auto file = reader.find("file")) {
    if (!file->one().value->is(Type::string)) refuse_type(file->one(), "the name of a file");
    throw ScriptError(Code::not_yet, file->span(), "meshes from files come with a later version",
                      "`mesh { points [..] faces [[0, 1, 2], ..] }` is there");
  }
  scene::Mesh mesh;
  mesh.points = read_points(reader.need("points"), meter);
  const Slot faces_slot = reader.need("faces");
  std::vector<Face> faces = read_faces(faces_slot, mesh.points.size(), meter);
  cut_into_facets(faces, mesh);
  const auto smooth = reader.find("smooth"), solid = reader.find("solid");
  const bool is_smooth = smooth && read_boolean(smooth->one());
  if (is_smooth) mesh.normals = smooth_normals(faces, mesh.points);
  if (solid && read_boolean(solid->one())) make_solid(mesh, meter, reader.kind_span());
  drop_flat_facets(mesh);
  if (mesh.faces.empty()) {
    throw ScriptError(Code::bad_mesh, faces_slot.span(),
                      "a mesh has faces with an area; all of these are flat");
  }
  return std::make_shared<const scene::Mesh>(std::move(mesh));
}

}  // namespace lancer::lang
