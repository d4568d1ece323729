#include "tracer/render.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>

#include "tracer/origin.hpp"
#include "tracer/sampling/equal.hpp"
#include "tracer/sampling/refine.hpp"

namespace lancer::tracer {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Tells the watcher of each band of rows that is complete.
class Bands {
 public:
  Bands(const Watch& watch, const image::Image& image)
      : watch_(watch),
        image_(image),
        left_(static_cast<std::size_t>((image.height() + k_tile_side - 1) / k_tile_side)) {
    for (std::atomic<int>& left : left_) left = (image.width() + k_tile_side - 1) / k_tile_side;
  }

  void done(const Tile& tile) {
    if (left_[static_cast<std::size_t>(tile.y0 / k_tile_side)].fetch_sub(1) != 1) return;
    if (watch_.rows) {
      const std::lock_guard lock(mutex_);
      watch_.rows(tile.y0, tile.y1, image_.row(tile.y0).data());
    }
    complete_.fetch_add(1);
  }

  bool all_done() const { return complete_.load() == left_.size(); }

 private:
  const Watch& watch_;
  const image::Image& image_;
  std::vector<std::atomic<int>> left_;  // tiles of each band
  std::atomic<std::size_t> complete_{0};
  std::mutex mutex_;
};

/// What each thread does with `drawer`, one of its own.
template <class Drawer>
TileWork drawing(const Job& job, const std::shared_ptr<Drawer>& drawer, Bands& bands, image::Image& image) {
  return [&job, drawer, &bands, &image](const Tile& tile) {
    drawer->draw(tile, image);
    if (!job.tracing.cancelled()) bands.done(tile);
  };
}

void draw_equally(const Job& job, int samples, Bands& bands, Rendered& out) {
  const auto work = [&](ViewTracer& tracer) {
    return drawing(job, std::make_shared<EqualDrawer>(tracer, samples), bands, out.image);
  };
  each_tile(job, out.image.width(), out.image.height(), work, out.stats);
}

void draw_to_error(const Job& job, double error, Bands& bands, Rendered& out) {
  Lattice lattice(job.region);
  const auto look = [&](ViewTracer& tracer) -> TileWork {
    return [&](const Tile& tile) { lattice.sample(tile.x0, tile.y0, tile.x1, tile.y1, tracer); };
  };
  each_tile(job, lattice.columns(), lattice.rows(), look, out.stats);
  if (job.tracing.cancelled()) return;
  const Display display(job.tracing.plan->exposure);
  // The rest is for what is left out for being faint.
  const Demand demand{&display, error * (1 - k_faint_part)};
  const auto work = [&](ViewTracer& tracer) {
    return drawing(job, std::make_shared<RefiningDrawer>(tracer, lattice, demand), bands, out.image);
  };
  each_tile(job, out.image.width(), out.image.height(), work, out.stats);
}

Region region_of(const Options& options, int columns, int rows) {
  if (!options.region) return {0, 0, columns, rows};
  const Region& r = *options.region;
  return {std::clamp(r.x0, 0, columns), std::clamp(r.y0, 0, rows), std::clamp(r.x1, 0, columns),
          std::clamp(r.y1, 0, rows)};
}

}  // namespace

std::uint64_t least_samples(std::uint64_t columns, std::uint64_t rows) {
  if (columns == 0 || rows == 0) return 0;
  return (columns + 3) * (rows + 3) + (columns + 2) * (rows + 2);
}

Rendered render(const scene::Scene& scene, const scene::View& view, const Options& options,
                const Watch& watch) {
  Rendered out;
  const int columns = options.columns.value_or(view.columns), rows = options.rows.value_or(view.rows);
  const auto build_start = std::chrono::steady_clock::now();
  out.stats.threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
  const Plan needed = plan(scene, view, options);
  World world;
  with_threads(out.stats.threads,
               [&] { world = prepare(scene, world_origin(scene, view.eye), watch.cancel, needed.tree); });
  Job job{{&world, &needed, watch.cancel},
          Camera(view, columns, rows, world.origin),
          region_of(options, columns, rows),
          {},
          {}};
  if (needed.media && job.camera.has_one_origin()) job.around_eye = solids_around(world, job.camera.eye());
  if (needed.packets && job.around_eye.empty()) job.packets.emplace(world, needed);
  out.stats.build_seconds = seconds_since(build_start);

  const auto render_start = std::chrono::steady_clock::now();
  out.image =
      image::Image(std::max(0, job.region.x1 - job.region.x0), std::max(0, job.region.y1 - job.region.y0));
  out.stats.pixels = out.image.data().size() / 3;
  Bands bands(watch, out.image);
  if (out.stats.pixels > 0) {
    options.samples > 0 ? draw_equally(job, options.samples, bands, out)
                        : draw_to_error(job, options.error, bands, out);
  }
  out.stats.render_seconds = seconds_since(render_start);
  out.cancelled = !bands.all_done();
  return out;
}

}  // namespace lancer::tracer
