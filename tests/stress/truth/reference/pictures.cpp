#include "stress/truth/reference/pictures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>
#include <tbb/parallel_for.h>

#include "memory_host.hpp"
#include "session/session.hpp"
#include "tracer/camera.hpp"
#include "tracer/media.hpp"
#include "tracer/origin.hpp"
#include "tracer/radiance.hpp"
#include "tracer/render.hpp"

namespace lancer::stress {
namespace {

std::size_t place(const scene::View& view, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(view.columns) +
         static_cast<std::size_t>(column);
}

tracer::Ray eye_ray(const tracer::World& world, bool media, const tracer::CameraRay& from,
                    tracer::Stats& stats) {
  tracer::Ray ray{from.origin, from.direction, 0, {}, {}};
  if (media) {
    ray.open =
        tracer::open_at(world, tracer::solids_around(world, from.origin), from.origin, from.direction, stats);
  }
  return ray;
}

/// One row of the picture against the truth.
Verdict judge_row(const std::string& name, const scene::Scene& scene, const scene::View& view,
                  const std::vector<Color>& mine, int row, const Measures& measures) {
  reference::Picture truth(scene, view, measures.tolerance);
  Verdict out;
  for (int column = 0; column < view.columns; ++column) {
    ++out.pixels;
    const Color seen = mine[place(view, column, row)], wanted = truth.pixel(column, row);
    // What is brighter than white is judged by its size.
    const double size = std::max({1.0, wanted.r, wanted.g, wanted.b}), limit = measures.limit * size;
    const double error = reference::difference(seen, wanted) / size;
    if (error > measures.limit) {
      ++out.wrong;
      if (truth.ambiguous(column, row, limit) ||
          (measures.excuse_near_things && truth.hangs_on_tolerance(column, row, limit))) {
        ++out.in_band;
        continue;
      }
    }
    if (error > out.worst) {
      out.worst = error;
      out.where = fmt::format("{} ({}, {}): {} for {}", name, column, row, seen.r, wanted.r);
    }
  }
  return out;
}

}  // namespace

Script::Script(const std::string& text) {
  test::MemoryHost host;
  session::Session session(host);
  const session::Run run = session.run_text("scene.scn", text, "/", {});
  if (run.outcome != session::Outcome::fine) {
    throw std::runtime_error(to_text(run.diagnostics, session.sources()) + run.problem + "\n" + text);
  }
  scene = session.scene();
  view = session.views().front();
}

std::vector<Color> drawn(const scene::Scene& scene, const scene::View& view) {
  tracer::Options options;
  options.samples = 1;
  const tracer::World world = tracer::prepare(scene, tracer::world_origin(scene, view.eye));
  const tracer::Plan plan = tracer::plan(scene, view, options);
  const tracer::Camera camera(view, view.columns, view.rows, world.origin);
  const tracer::Rendered rendered = tracer::render(scene, view, options);
  std::vector<Color> out(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows));
  tbb::parallel_for(0, view.rows, [&](int row) {
    tracer::Tracer tracer({&world, &plan, nullptr});
    for (int column = 0; column < view.columns; ++column) {
      const tracer::Ray ray = eye_ray(world, plan.media, camera.ray(column + 0.5, row + 0.5), tracer.stats());
      out[place(view, column, row)] = tracer.radiance(ray, scene.settings.depth);
    }
  });
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < view.columns; ++column) {
      const Color c = out[place(view, column, row)];
      const auto p = rendered.image.pixel(column, row);
      // Not equal where one is no number: then the judgement of the doubles says so.
      const auto differs = [](double a, float b) {
        const auto rounded =
            static_cast<float>(std::min(a, static_cast<double>(std::numeric_limits<float>::max())));
        return rounded < b || rounded > b;
      };
      if (differs(c.r, p[0]) || differs(c.g, p[1]) || differs(c.b, p[2])) {
        throw std::runtime_error(
            fmt::format("pixel ({}, {}) is {} alone, {} in a picture", column, row, c.r, p[0]));
      }
    }
  }
  return out;
}

void Verdict::add(const Verdict& other) {
  pixels += other.pixels;
  wrong += other.wrong;
  in_band += other.in_band;
  if (other.worst > worst || where.empty()) {
    worst = other.worst;
    where = other.where;
  }
}

Verdict judge(const std::string& name, const scene::Scene& scene, const scene::View& view,
              const Measures& measures) {
  const std::vector<Color> mine = drawn(scene, view);
  std::vector<Verdict> rows(static_cast<std::size_t>(view.rows));
  tbb::parallel_for(0, view.rows, [&](int row) {
    rows[static_cast<std::size_t>(row)] = judge_row(name, scene, view, mine, row, measures);
  });
  Verdict all;
  for (const Verdict& row : rows) all.add(row);
  return all;
}

Verdict judge(const std::string& name, const std::string& script, const Measures& measures) {
  const Script loaded(script);
  return judge(name, loaded.scene, loaded.view, measures);
}

Outcome outcome(const Verdict& verdict, const Measures& measures) {
  Outcome out;
  out.measures.push_back(measure_in_use("pictures", verdict.pixels, verdict.wrong, verdict.in_band));
  out.limits.push_back({"wrong pixels", static_cast<double>(verdict.wrong - verdict.in_band), 0});
  out.limits.push_back({"largest error", verdict.worst, measures.limit});
  if (verdict.worst > 0) out.note = "largest error: " + verdict.where;
  return out;
}

Outcome outcome(const Scripts& scripts, const Measures& measures) {
  Verdict all;
  for (const auto& [name, text] : scripts) all.add(judge(name, text, measures));
  return outcome(all, measures);
}

}  // namespace lancer::stress
