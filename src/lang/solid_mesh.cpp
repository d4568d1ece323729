// Does a mesh enclose a volume, and which side of it is outside?

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "lang/build_parts.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// The facets with points at the same place made one, so that a mesh whose faces have points of their own is
/// closed where it looks closed. Facets that vanish by this have no edges left to pair.
std::vector<Corners> welded(const scene::Mesh& mesh) {
  std::map<std::tuple<double, double, double>, std::uint32_t> places;
  std::vector<std::uint32_t> same(mesh.points.size());
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3 p = mesh.points[i];
    same[i] = places.try_emplace({p.x, p.y, p.z}, i).first->second;
  }
  std::vector<Corners> out;
  for (const Corners& f : mesh.faces) {
    const Corners w{same[f[0]], same[f[1]], same[f[2]]};
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) out.push_back(w);
  }
  return out;
}

/// How often an edge is run through upwards (by index) and downwards.
struct EdgeUse {
  std::uint32_t up = 0, down = 0;
};

[[noreturn]] void refuse_solid(Span span, std::string message, std::string help) {
  throw ScriptError(Code::bad_mesh, span, std::move(message), std::move(help));
}

void check_edges(const std::vector<Corners>& facets, Meter& meter, Span span) {
  std::unordered_map<std::uint64_t, EdgeUse> edges;
  for (const Corners& f : facets) {
    meter.charge(1, span);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = f[i], b = f[(i + 1) % 3];
      EdgeUse& use = edges[std::min(a, b) << 32 | std::max(a, b)];
      ++(a < b ? use.up : use.down);
    }
  }
  bool is_open = false, is_mixed = false;
  for (const auto& [edge, use] : edges) {
    is_open = is_open || (use.up + use.down) % 2 == 1;
    is_mixed = is_mixed || use.up != use.down;
  }
  if (is_open) {
    refuse_solid(span, "a solid mesh is closed; this one has a hole",
                 "every edge belongs to two faces; leave `solid` out for an open surface");
  }
  if (is_mixed) {
    refuse_solid(span, "a solid mesh winds the same way throughout",
                 "the points of a face run counter-clockwise as seen from outside");
  }
}

/// Facets that hang together by their points.
class Parts {
 public:
  Parts(const std::vector<Corners>& facets, std::size_t points) : parent_(points) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const Corners& f : facets) {
      unite(f[0], f[1]);
      unite(f[0], f[2]);
    }
  }
  std::uint32_t of(const Corners& f) { return find(f[0]); }

 private:
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }
  std::vector<std::uint32_t> parent_;
};

struct Part {
  std::vector<Corners> facets;
  double volume = 0;  // times six and a power of eight; negative where it is wound inwards
};

/// Coordinates as fractions of the largest, so that volumes neither overflow nor vanish.
std::vector<Vec3> as_fractions(const std::vector<Vec3>& points) {
  double most = 0;
  for (const Vec3 p : points) most = std::max(most, max_abs(p));
  const int exponent = most == 0 ? 0 : -std::ilogb(most) - 1;
  std::vector<Vec3> out;
  for (const Vec3 p : points) out.push_back(times_power_of_two(p, exponent));
  return out;
}

std::vector<Part> parts_of(const std::vector<Corners>& facets, const std::vector<Vec3>& points) {
  Parts groups(facets, points.size());
  std::map<std::uint32_t, Part> parts;
  for (const Corners& f : facets) {
    Part& part = parts[groups.of(f)];
    part.facets.push_back(f);
    const Vec3 from = points[part.facets.front()[0]];
    part.volume += dot(points[f[0]] - from, cross(points[f[1]] - from, points[f[2]] - from));
  }
  std::vector<Part> out;
  for (auto& [root, part] : parts) out.push_back(std::move(part));
  return out;
}

/// How often `part` winds around p: 1 inside one that is wound outwards, 0 outside. The sum of the solid
/// angles of its facets (A. van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983).
double winding(const Part& part, const std::vector<Vec3>& points, Vec3 p) {
  double sum = 0;
  for (const Corners& f : part.facets) {
    const Vec3 a = points[f[0]] - p, b = points[f[1]] - p, c = points[f[2]] - p;
    const double la = length(a), lb = length(b), lc = length(c);
    sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / 6.283185307179586;
}

/// Whether, seen with this sign, every part is wound outwards or is a hollow within another.
bool is_outward(const std::vector<Part>& parts, const std::vector<Vec3>& points, double sign, Meter& meter,
                Span span) {
  for (const Part& part : parts) {
    if (sign * part.volume > 0) continue;
    double around = 0;
    for (const Part& other : parts) {
      meter.charge(other.facets.size(), span);
      if (&other != &part) around += sign * winding(other, points, points[part.facets.front()[0]]);
    }
    if (around < 0.5) return false;
  }
  return true;
}

}  // namespace

void make_solid(scene::Mesh& mesh, Meter& meter, Span span) {
  const std::vector<Corners> facets = welded(mesh);
  check_edges(facets, meter, span);
  const std::vector<Vec3> points = as_fractions(mesh.points);
  const std::vector<Part> parts = parts_of(facets, points);
  const bool is_empty = std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.volume == 0; });
  if (is_empty)
    refuse_solid(span, "a solid mesh encloses a volume; this one is flat", "leave `solid` out for a surface");
  mesh.solid = true;
  if (is_outward(parts, points, 1, meter, span)) return;
  if (!is_outward(parts, points, -1, meter, span)) {
    refuse_solid(span, "a solid mesh winds the same way throughout",
                 "the points of a face run counter-clockwise as seen from outside");
  }
  for (Corners& f : mesh.faces) std::swap(f[1], f[2]);
  for (Vec3& n : mesh.normals) n = -n;
}

}  // namespace lancer::lang
