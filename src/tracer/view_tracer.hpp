#pragma once
// From points of the screen to the light that arrives there: what every way of sampling asks.

#include <span>
#include <vector>

#include "tracer/camera.hpp"
#include "tracer/media.hpp"
#include "tracer/radiance.hpp"

namespace lancer::tracer {

/// In pixels from the view's left and top edge; a pixel's centre lies at halves.
struct ScreenPoint {
  double x = 0, y = 0;
};

/// What all threads of one picture read.
struct Job {
  Tracing tracing;
  Camera camera;
  Region region;                        // within the view
  std::vector<Surrounding> around_eye;  // where all rays start there
};

/// One thread's.
class ViewTracer {
 public:
  explicit ViewTracer(const Job& job) : job_(job), tracer_(job.tracing) {}

  /// The linear radiance at each of the points, in their order, into `out`, which is as long. No meaningful
  /// values once cancelled.
  void radiances(std::span<const ScreenPoint> points, std::span<Color> out);

  const Job& job() const { return job_; }
  Stats& stats() { return tracer_.stats(); }

 private:
  Ray ray(ScreenPoint at);

  const Job& job_;
  Tracer tracer_;
};

}  // namespace lancer::tracer
