#include "tracer/threads.hpp"

#include <algorithm>
#include <mutex>
#include <tbb/task_group.h>

namespace lancer::tracer {
namespace {

/// Hands tiles out in reading order.
class Tiles {
 public:
  Tiles(const Job& job, int columns, int rows, const WorkOfThread& work, Stats& total)
      : job_(job),
        columns_(columns),
        rows_(rows),
        across_((columns + k_tile_side - 1) / k_tile_side),
        down_((rows + k_tile_side - 1) / k_tile_side),
        work_(work),
        total_(total) {
    next_.store(0, std::memory_order_release);
  }

  /// Makes what the threads wrote visible to the caller.
  void join() { const std::lock_guard lock(mutex_); }

  /// What one thread does until no tile is left. The counter's first value, which the constructor released,
  /// orders everything made before the threads started.
  void work() {
    next_.load(std::memory_order_acquire);
    ViewTracer tracer(job_);
    const TileWork draw = work_(tracer);
    while (!job_.tracing.cancelled()) {
      const std::int64_t tile = next_.fetch_add(1, std::memory_order_relaxed);
      if (tile >= count()) break;
      const int x = static_cast<int>(tile % across_) * k_tile_side,
                y = static_cast<int>(tile / across_) * k_tile_side;
      draw({x, y, std::min(columns_, x + k_tile_side), std::min(rows_, y + k_tile_side)});
    }
    const std::lock_guard lock(mutex_);
    total_.add(tracer.stats());
  }

 private:
  std::int64_t count() const { return std::int64_t{across_} * down_; }

  const Job& job_;
  int columns_, rows_, across_, down_;
  const WorkOfThread& work_;
  Stats& total_;
  std::atomic<std::int64_t> next_{0};
  std::mutex mutex_;
};

/// The task of one thread. ThreadSanitizer does not see how TBB hands tasks over, so it is told not to look
/// at how this one is read; what happens in work() is ordered by Tiles itself.
struct Worker {
  Tiles* tiles;
#if defined(__GNUC__)
  __attribute__((no_sanitize("thread")))
#endif
  void
  operator()() const {
    tiles->work();
  }
};

}  // namespace

void each_tile(const Job& job, int columns, int rows, const WorkOfThread& work, Stats& stats) {
  Tiles tiles(job, columns, rows, work, stats);
  const Worker worker{&tiles};
  const int threads = stats.threads;
  with_threads(threads, [&] {
    tbb::task_group group;
    for (int i = 1; i < threads; ++i) group.run(worker);
    group.run_and_wait(worker);
  });
  tiles.join();
}

}  // namespace lancer::tracer
