// Planes of facets that are met exactly at their corners and edges.

#include <fmt/format.h>

#include "stress/contest/clock.hpp"
#include "stress/contest/line.hpp"
#include "stress/rows/rows.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

constexpr int k_cells = 64;  // each way, two facets each

/// The square [-1, 1]^2, `slope` times as steep, moved and scaled; every step is exact but the scale by 1e-4.
struct Sheet {
  std::string name;
  double slope = 0, scale = 1, away = 0;

  Vec3 point(double i, double j) const {
    const double x = (i - 32) / 32, y = (j - 32) / 32;
    const Vec3 p{x + away, y + away, slope * (x + y * 0.5) - away};
    return p * scale;
  }
};

scene::Mesh field_mesh(const Sheet& field) {
  scene::Mesh mesh;
  for (int j = 0; j <= k_cells; ++j) {
    for (int i = 0; i <= k_cells; ++i) mesh.points.push_back(field.point(i, j));
  }
  for (int j = 0; j < k_cells; ++j) {
    for (int i = 0; i < k_cells; ++i) {
      const auto at = static_cast<std::uint32_t>(j * (k_cells + 1) + i);
      const std::uint32_t above = at + k_cells + 1;
      mesh.faces.push_back({at, at + 1, above + 1});
      mesh.faces.push_back({at, above + 1, above});
    }
  }
  return mesh;
}

/// Through an inner corner, or the middle of an edge, of cell (i, j).
Vec3 field_target(const Sheet& field, int i, int j, bool corner) {
  const double x = 1 + i % (k_cells - 1), y = 1 + j % (k_cells - 1);
  if (corner) return field.point(x, y);
  const double dx = (i + j) % 3 == 0 ? 0 : 0.5, dy = (i + j) % 3 == 1 ? 0 : 0.5;
  return field.point(x - dx, y - dy);
}

std::uint64_t holes(const Sheet& field, const tracer::World& world, bool corner, bool parallel,
                    std::string& note) {
  std::uint64_t count = 0;
  for (int j = 0; j < k_cells; ++j) {
    for (int i = 0; i < k_cells; ++i) {
      const Vec3 target = field_target(field, i, j, corner);
      tracer::Ray ray;
      ray.direction = {0, 0, -1};
      ray.origin = target - ray.direction * (4 * field.scale);
      if (!parallel) {
        ray.origin = field.point(40.3, 11.7) + Vec3{0, 0, 3 * field.scale};
        ray.direction = normalize(target - ray.origin);
      }
      tracer::Stats stats;
      tracer::Hit hit;
      if (closest(world, ray, stats, hit)) continue;
      ++count;
      if (note.empty()) note = fmt::format("{}: {}", field.name, told(ray.origin, ray.direction));
    }
  }
  return count;
}

Outcome vertices(const Settings&) {
  Outcome outcome;
  for (const Sheet& field :
       {Sheet{"flat", 0, 1, 0}, Sheet{"sloped", 0.5, 1, 0}, Sheet{"flat, scaled 1e-4", 0, 1e-4, 0},
        Sheet{"sloped, scaled 1e-4", 0.5, 1e-4, 0}, Sheet{"flat, moved 1e5", 0, 1, 1e5},
        Sheet{"sloped, moved 1e5", 0.5, 1, 1e5}, Sheet{"flat, moved 1e9", 0, 1, 1e9},
        Sheet{"sloped, moved 1e9", 0.5, 1, 1e9}}) {
    scene::Scene scene;
    tracer::test::add_mesh(scene, field_mesh(field));
    const tracer::World world = tracer::prepare(scene);
    Measure measure = measure_in_use("in use");
    measure.set = field.name;
    const double start = now_in_nanoseconds();
    for (const bool corner : {true, false}) {
      for (const bool parallel : {true, false}) {
        measure.leaks += holes(field, world, corner, parallel, outcome.note);
        measure.rays += k_cells * k_cells;
      }
    }
    measure.nanoseconds = (now_in_nanoseconds() - start) / static_cast<double>(measure.rays);
    outcome.measures.push_back(measure);
  }
  double leaks = 0;
  for (const Measure& measure : outcome.measures) leaks += static_cast<double>(measure.leaks);
  outcome.limits.push_back({"holes", leaks, 0});
  return outcome;
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_mesh_vertices_rows(Rows& rows) {
  rows.push_back({"mesh.vertices", "planes of 8192 facets, each of 64 x 64 rays through a corner or an edge",
                  flat::vertices});
}
