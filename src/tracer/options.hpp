#pragma once
// What a picture is asked for beyond the scene and the view.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

namespace lancer::tracer {

/// Pixels [x0, x1) x [y0, y1) of a view.
struct Region {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct Options {
  std::optional<int> columns, rows;  // in place of the view's size
  std::optional<Region> region;  // only this part; the image has its size, its pixels are those of the whole
  int samples = 16;              // a pixel, stratified; 1 is the pixel's centre
  int threads = 0;               // 0: as many as the machine has
};

/// How a caller watches and stops a render. Both members may be empty.
struct Watch {
  const std::atomic<bool>* cancel = nullptr;  // set: the render returns soon, with what it has
  /// Called when rows [y0, y1) of the image are finished, each row once, never from two threads at once, in
  /// any order. `rgb` is the first value of row y0.
  std::function<void(int y0, int y1, const float* rgb)> rows;
};

/// What a render did.
struct Stats {
  std::uint64_t primary_rays = 0, reflected_rays = 0, refracted_rays = 0, shadow_rays = 0;
  std::uint64_t shape_tests = 0, node_visits = 0;
  double build_seconds = 0, render_seconds = 0;
  int threads = 1;
};

}  // namespace lancer::tracer
