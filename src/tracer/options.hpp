#pragma once
// What a picture is asked for beyond the scene and the view.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "tracer/skip.hpp"

namespace lancer::tracer {

/// Pixels [x0, x1) x [y0, y1) of a view.
struct Region {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct Options {
  std::optional<int> columns, rows;  // in place of the view's size
  std::optional<Region> region;  // only this part; the image has its size, its pixels are those of the whole
  /// A pixel, stratified; 1 is the pixel's centre. 0: as many in each as `error`, which then is not 0, asks
  /// for.
  int samples = 16;
  int threads = 0;  // 0: as many as the machine has
  /// The error asked for of every pixel: the root mean square over its square, in display units (0 to 1,
  /// after exposure and the sRGB curve). 0: whatever `samples` give, nothing left out for being faint.
  double error = 0;
  Skips skips = Skips::all();  // what may be left out
};

/// How a caller watches and stops a render. Both members may be empty.
struct Watch {
  const std::atomic<bool>* cancel = nullptr;  // set: the render returns soon, with what it has
  /// Called when rows [y0, y1) of the image are finished, each row once, never from two threads at once, in
  /// any order. `rgb` is the first value of row y0.
  std::function<void(int y0, int y1, const float* rgb)> rows;
};

/// What a render did, and what it spared by leaving out what is not needed.
struct Stats {
  std::uint64_t primary_rays = 0, reflected_rays = 0, refracted_rays = 0, shadow_rays = 0;
  std::uint64_t shape_tests = 0, node_visits = 0;
  std::uint64_t branchings = 0;       // surfaces at which rays to go on with were looked for
  std::uint64_t medium_changes = 0;   // surfaces at which a ray's list of open solids was asked or changed
  std::uint64_t pattern_lookups = 0;  // colours worked out at a point
  /// Shadow rays that were not shot because the light
  std::uint64_t lights_behind = 0;        // is behind the surface
  std::uint64_t lights_outside_cone = 0;  // does not shine there
  std::uint64_t lights_unanswered = 0;    // meets a surface that sends none of it back
  std::uint64_t lights_faint = 0;         // is too weak to show
  std::uint64_t rays_faint = 0;           // reflected and refracted rays too weak to show
  std::uint64_t pixels = 0;               // of the image
  std::uint64_t refined_pixels = 0;       // that more than the first look was needed for
  std::uint64_t edge_pixels = 0;          // of these, in which one straight edge was found
  double build_seconds = 0, render_seconds = 0;
  int threads = 1;

  /// Adds what another thread counted.
  void add(const Stats& other) {
    constexpr std::uint64_t Stats::*k_counts[] = {
        &Stats::primary_rays,  &Stats::reflected_rays,      &Stats::refracted_rays,
        &Stats::shadow_rays,   &Stats::shape_tests,         &Stats::node_visits,
        &Stats::branchings,    &Stats::medium_changes,      &Stats::pattern_lookups,
        &Stats::lights_behind, &Stats::lights_outside_cone, &Stats::lights_unanswered,
        &Stats::lights_faint,  &Stats::rays_faint,          &Stats::refined_pixels,
        &Stats::edge_pixels};
    for (const auto count : k_counts) this->*count += other.*count;
  }
};

}  // namespace lancer::tracer
