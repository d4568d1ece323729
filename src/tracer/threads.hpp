#pragma once
// The threads of a picture, and the tiles that they draw.

#include <functional>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "tracer/view_tracer.hpp"

namespace lancer::tracer {

/// Does the work where `threads` threads help, which may be more than the machine has.
template <class Work>
void with_threads(int threads, const Work& work) {
  constexpr auto k_limit = tbb::global_control::max_allowed_parallelism;
  const std::size_t now = tbb::global_control::active_value(k_limit);
  const tbb::global_control limit(k_limit, std::max(now, static_cast<std::size_t>(threads)));
  tbb::task_arena(threads).execute(work);
}

/// The places [x0, x1) x [y0, y1) of a grid.
struct Tile {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

inline constexpr int k_tile_side = 32;

/// One thread's part: called once a tile.
using TileWork = std::function<void(const Tile&)>;
/// What each thread starts with; its tracer lives as long as the work that it gives.
using WorkOfThread = std::function<TileWork(ViewTracer&)>;

/// Has the tiles of a grid of columns x rows, each of k_tile_side squared or what the edges leave of it, done
/// by `stats.threads` threads, which begin them in reading order, until all are done or the job is
/// cancelled; adds to `stats` what the threads counted.
void each_tile(const Job& job, int columns, int rows, const WorkOfThread& work, Stats& stats);

}  // namespace lancer::tracer
