#include "tracer/render.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <vector>

#include "tracer/camera.hpp"
#include "tracer/media.hpp"
#include "tracer/origin.hpp"
#include "tracer/packet/block.hpp"
#include "tracer/radiance.hpp"
#include "tracer/sample.hpp"

namespace lancer::tracer {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What all threads of one picture read.
struct Job {
  Tracing tracing;
  Camera camera;
  Region region;
  int samples = 1;
  std::vector<Surrounding> around_eye;  // where all rays start there
  std::optional<PacketWorld> packets;   // where rays go together
};

/// One thread's way from pixels to colours.
class PixelTracer {
 public:
  explicit PixelTracer(const Job& job) : job_(job), tracer_(job.tracing) {
    if (job.packets) block_.emplace(*job.packets, job.tracing, tracer_);
  }

  /// The mean radiance of each pixel of the image's region, which has k_wave at the most, row by row; no
  /// meaningful values once cancelled.
  const Color* block(const Region& pixels) {
    const int width = pixels.x1 - pixels.x0;
    if (block_) {
      add_together(pixels);
    } else {
      for (int y = pixels.y0; y < pixels.y1 && !job_.tracing.cancelled(); ++y) {
        for (int x = pixels.x0; x < pixels.x1; ++x)
          colors_[static_cast<std::size_t>((y - pixels.y0) * width + x - pixels.x0)] = pixel(x, y);
      }
    }
    return colors_.data();
  }

  const Stats& stats() { return tracer_.stats(); }

 private:
  /// In squares of 4 x 4 pixels, whose rays search together.
  void add_together(const Region& pixels) {
    colors_.fill({});
    const int width = pixels.x1 - pixels.x0;
    for (int i = 0; i < job_.samples && !job_.tracing.cancelled(); ++i) {
      block_->clear();
      for (int y0 = pixels.y0; y0 < pixels.y1; y0 += 4) {
        for (int x0 = pixels.x0; x0 < pixels.x1; x0 += 4) {
          for (int y = y0; y < std::min(y0 + 4, pixels.y1); ++y) {
            for (int x = x0; x < std::min(x0 + 4, pixels.x1); ++x) {
              const PixelPoint at = pixel_point(x, y, i, job_.samples);
              block_->add_ray(job_.camera.ray(x + at.x, y + at.y),
                              static_cast<std::size_t>((y - pixels.y0) * width + x - pixels.x0));
            }
          }
        }
      }
      tracer_.stats().primary_rays += block_->size();
      block_->add_radiance(job_.tracing.world->scene->settings.depth, colors_.data());
    }
    for (Color& c : colors_) c = {c.r / job_.samples, c.g / job_.samples, c.b / job_.samples};
  }

  /// The mean radiance of the pixel; no meaningful value once cancelled.
  Color pixel(int column, int row) {
    Color sum;
    for (int i = 0; i < job_.samples && !job_.tracing.cancelled(); ++i) {
      const PixelPoint at = pixel_point(column, row, i, job_.samples);
      sum += tracer_.radiance(ray(column + at.x, row + at.y), job_.tracing.world->scene->settings.depth);
      ++tracer_.stats().primary_rays;
    }
    return {sum.r / job_.samples, sum.g / job_.samples, sum.b / job_.samples};
  }

  Ray ray(double x, double y) {
    const CameraRay from = job_.camera.ray(x, y);
    Ray ray{from.origin, from.direction, 0, {}, {}};
    if (job_.tracing.plan->media) {
      const World& world = *job_.tracing.world;
      ray.open =
          job_.camera.has_one_origin()
              ? open_at(world, job_.around_eye, ray.origin, ray.direction, tracer_.stats())
              : open_at(world, solids_around(world, ray.origin), ray.origin, ray.direction, tracer_.stats());
    }
    return ray;
  }

  const Job& job_;
  Tracer tracer_;
  std::optional<BlockTracer> block_;
  std::array<Color, k_wave> colors_;
};

float to_float(double radiance) {
  return static_cast<float>(std::min(radiance, static_cast<double>(std::numeric_limits<float>::max())));
}

/// Hands tiles out in reading order, and tells the watcher of each band of rows that is complete.
class Tiles {
 public:
  Tiles(const Job& job, const Watch& watch, image::Image& image)
      : job_(job),
        watch_(watch),
        image_(image),
        across_((image.width() + k_side - 1) / k_side),
        down_((image.height() + k_side - 1) / k_side),
        left_(static_cast<std::size_t>(down_)) {
    for (std::atomic<int>& left : left_) left = across_;
    next_.store(0, std::memory_order_release);
  }

  /// Makes what the threads wrote visible to the caller.
  void join() { const std::lock_guard lock(stats_mutex_); }

  /// What one thread does until no tile is left. The counter's first value, which the constructor released,
  /// orders everything made before the threads started.
  void work(Stats& total) {
    next_.load(std::memory_order_acquire);
    PixelTracer tracer(job_);
    while (!job_.tracing.cancelled()) {
      const std::int64_t tile = next_.fetch_add(1, std::memory_order_relaxed);
      if (tile >= std::int64_t{across_} * down_) break;
      draw(tracer, static_cast<int>(tile % across_), static_cast<int>(tile / across_));
    }
    const std::lock_guard lock(stats_mutex_);
    total.add(tracer.stats());
  }

  bool finished() const { return bands_done_.load() == down_; }

 private:
  static constexpr int k_side = 16;
  static_assert(k_side * k_side <= k_wave);

  void draw(PixelTracer& tracer, int tile_x, int tile_y) {
    const int x1 = std::min(image_.width(), (tile_x + 1) * k_side);
    const int y0 = tile_y * k_side, y1 = std::min(image_.height(), y0 + k_side);
    const Region& all = job_.region;
    const Color* color = tracer.block({all.x0 + tile_x * k_side, all.y0 + y0, all.x0 + x1, all.y0 + y1});
    // A tile that was cut short stays black.
    if (job_.tracing.cancelled()) return;
    for (int y = y0; y < y1; ++y) {
      for (int x = tile_x * k_side; x < x1; ++x, ++color) {
        const auto out = image_.pixel(x, y);
        out[0] = to_float(color->r);
        out[1] = to_float(color->g);
        out[2] = to_float(color->b);
      }
    }
    if (left_[static_cast<std::size_t>(tile_y)].fetch_sub(1) != 1) return;
    if (watch_.rows) {
      const std::lock_guard lock(rows_mutex_);
      watch_.rows(y0, y1, image_.row(y0).data());
    }
    bands_done_.fetch_add(1);
  }

  const Job& job_;
  const Watch& watch_;
  image::Image& image_;
  int across_, down_;
  std::atomic<std::int64_t> next_{0};
  std::vector<std::atomic<int>> left_;  // tiles of each band
  std::atomic<int> bands_done_{0};
  std::mutex rows_mutex_, stats_mutex_;
};

/// The task of one thread. ThreadSanitizer does not see how TBB hands tasks over, so it is told not to look
/// at how this one is read; what happens in work() is ordered by Tiles itself.
struct Worker {
  Tiles* tiles;
  Stats* total;
#if defined(__GNUC__)
  __attribute__((no_sanitize("thread")))
#endif
  void
  operator()() const {
    tiles->work(*total);
  }
};

/// Does the work where `threads` threads help, which may be more than the machine has.
template <class Work>
void with_threads(int threads, const Work& work) {
  constexpr auto k_limit = tbb::global_control::max_allowed_parallelism;
  const std::size_t now = tbb::global_control::active_value(k_limit);
  const tbb::global_control limit(k_limit, std::max(now, static_cast<std::size_t>(threads)));
  tbb::task_arena(threads).execute(work);
}

/// Runs the worker on each of the threads.
void on_threads(int threads, const Worker& worker) {
  with_threads(threads, [&] {
    tbb::task_group group;
    for (int i = 1; i < threads; ++i) group.run(worker);
    group.run_and_wait(worker);
  });
}

}  // namespace

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
          {0, 0, columns, rows},
          options.samples,
          {},
          {}};
  if (options.region) {
    const Region& r = *options.region;
    job.region = {std::clamp(r.x0, 0, columns), std::clamp(r.y0, 0, rows), std::clamp(r.x1, 0, columns),
                  std::clamp(r.y1, 0, rows)};
  }
  if (needed.media && job.camera.has_one_origin()) job.around_eye = solids_around(world, job.camera.eye());
  // Rays that go together start in no solid whose medium matters.
  if (needed.packets && job.around_eye.empty()) job.packets.emplace(world, needed.shadows);
  out.stats.build_seconds = seconds_since(build_start);

  const auto render_start = std::chrono::steady_clock::now();
  out.image =
      image::Image(std::max(0, job.region.x1 - job.region.x0), std::max(0, job.region.y1 - job.region.y0));
  Tiles tiles(job, watch, out.image);
  on_threads(out.stats.threads, {&tiles, &out.stats});
  tiles.join();
  out.stats.render_seconds = seconds_since(render_start);
  out.cancelled = !tiles.finished();
  return out;
}

}  // namespace lancer::tracer
