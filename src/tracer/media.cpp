#include "tracer/media.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/intersect.hpp"
#include "tracer/shapes/solid_angle.hpp"

namespace lancer::tracer {
namespace {

/// Where the ray first leaves the shape; infinite where it never does.
Landing way_out(const World& world, std::uint32_t shape, const Probe& probe, Stats& stats) {
  Root nearest{k_infinity, 0, false};
  std::uint32_t through = world.first_primitive[shape];
  const auto test = [&](std::uint32_t primitive) {
    ++stats.shape_tests;
    const Roots found = roots(world, primitive, probe);
    const Interval own = found.count > 0 ? own_interval(world, primitive, probe) : Interval{};
    for (int i = 0; i < found.count && own.enter <= own.leave; ++i) {
      const Root& root = found.root[i];
      if (root.entering || !(root.t > 0) || !(root.t < nearest.t)) continue;
      nearest = root;
      through = primitive;
    }
  };
  const std::uint32_t first = world.first_primitive[shape], last = world.first_primitive[shape + 1];
  const auto exactly = [&] {
    return std::isinf(nearest.t) ? Landing{nearest, 0, 0, {}, {}}
                                 : land(world, through, probe.origin, probe.direction, nearest);
  };
  if (last - first == 1) {
    test(first);
    return exactly();
  }
  if (world.bounded.empty()) {  // no tree
    for (std::uint32_t primitive = first; primitive < last; ++primitive) test(primitive);
    return exactly();
  }
  world.tree.traverse(probe, nearest.t, stats.node_visits, [&](std::uint32_t item) {
    const std::uint32_t primitive = world.bounded[item];
    if (primitive >= first && primitive < last) test(primitive);
    return false;
  });
  return exactly();
}

/// Two ways out, neither of which may be any farther but for the rounding of the surfaces?
bool may_coincide(const Landing& farther, const Landing& nearer) {
  if (std::isinf(nearer.root.t)) return true;
  return gap(farther, nearer) <= farther.span().before + nearer.span().after;
}

const FacetPrimitive& facet_at(const World& world, std::uint32_t primitive) {
  return world.facets[world.primitives[primitive].record];
}

/// A mesh as a point sees it that is exactly on it.
Surrounding touched_mesh(const World& world, std::uint32_t shape, Vec3 p) {
  Surrounding mesh{shape, true, {}, 0};
  for (std::uint32_t i = world.first_primitive[shape]; i < world.first_primitive[shape + 1]; ++i) {
    const Seen seen = seen_from(facet_at(world, i), p);
    if (seen.touched) mesh.on.push_back(i);
    mesh.turns += seen.turns;
  }
  return mesh;
}

/// Is a ray from a point exactly on the solid's surface about to be inside?
bool goes_in(const World& world, const Surrounding& solid, const Probe& probe) {
  if (!solid.on.empty()) {
    double turns = solid.turns;
    for (const std::uint32_t i : solid.on)
      turns += turns_ahead(facet_at(world, i), probe.origin, probe.direction);
    return turns > 0.5;
  }
  const Roots found = roots(world, world.first_primitive[solid.shape], probe);
  if (found.count == 2) return found.root[1].t > 0;
  return found.count == 1 && found.root[0].entering;
}

}  // namespace

double refractive_index(const World& world, const OpenSolids& open) {
  return open.empty() ? world.scene->settings.ior : world.material_of(open.back()).ior;
}

void cross(const World& world, OpenSolids& open, std::uint32_t shape, bool entering) {
  if (!encloses(*world.scene, shape)) return;
  const auto at = std::find(open.begin(), open.end(), shape);
  if (entering && at == open.end()) open.push_back(shape);
  if (!entering && at != open.end()) open.erase(static_cast<std::size_t>(at - open.begin()));
}

std::vector<Surrounding> solids_around(const World& world, Vec3 p) {
  std::vector<std::uint32_t> shapes;
  const auto add = [&](std::uint32_t primitive) {
    const Primitive& one = world.primitives[primitive];
    if (one.kind != Kind::facet) shapes.push_back(one.shape);
  };
  for (const std::uint32_t primitive : world.unbounded) add(primitive);
  for (const std::uint32_t primitive : world.listed_spheres.numbers()) add(primitive);
  world.tree.around(p, [&](std::uint32_t item) { add(world.bounded[item]); });
  for (const SolidMesh& mesh : world.solid_meshes) {
    if (mesh.bounds.contains(p)) shapes.push_back(mesh.shape);
  }
  std::sort(shapes.begin(), shapes.end());
  std::vector<Surrounding> around;
  for (const std::uint32_t shape : shapes) {
    const double where = side(world, shape, p);
    if (where > 0) continue;
    const bool on_mesh = where == 0 && world.primitives[world.first_primitive[shape]].kind == Kind::facet;
    around.push_back(on_mesh ? touched_mesh(world, shape, p) : Surrounding{shape, where == 0, {}, 0});
  }
  return around;
}

OpenSolids open_at(const World& world, const std::vector<Surrounding>& around, Vec3 origin, Vec3 direction,
                   Stats& stats) {
  struct Way {
    std::uint32_t shape;
    Landing out;
  };
  OpenSolids open;
  if (around.empty()) return open;
  const Probe probe(origin, direction);
  std::vector<Way> ways;
  for (const Surrounding& solid : around) {
    if (solid.touched && !goes_in(world, solid, probe)) continue;
    ways.push_back({solid.shape, around.size() == 1 ? Landing{} : way_out(world, solid.shape, probe, stats)});
  }
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.out.root.t > b.out.root.t; });
  // Coincident surfaces differ by no more than rounding, which must not decide.
  for (auto first = ways.begin(); first != ways.end();) {
    auto last = first + 1;
    while (last != ways.end() && may_coincide((last - 1)->out, last->out)) ++last;
    std::sort(first, last, [](const Way& a, const Way& b) { return a.shape < b.shape; });
    first = last;
  }
  for (const Way& way : ways) open.push_back(way.shape);
  return open;
}

}  // namespace lancer::tracer
