#pragma once
// From points of the screen to the light that arrives there: what every way of sampling asks.

#include <optional>
#include <span>
#include <vector>

#include "tracer/camera.hpp"
#include "tracer/media.hpp"
#include "tracer/packet/block.hpp"
#include "tracer/radiance.hpp"

namespace lancer::tracer {

/// What all threads of one picture read.
struct Job {
  Tracing tracing;
  Camera camera;
  Region region;                        // within the view
  std::vector<Surrounding> around_eye;  // where all rays start there
  std::optional<PacketWorld> packets;   // where rays go together
};

/// One thread's.
class ViewTracer {
 public:
  explicit ViewTracer(const Job& job) : job_(job), tracer_(job.tracing) {
    if (job.packets) block_.emplace(*job.packets, job.tracing, tracer_);
  }

  /// The linear radiance at each of the points, in their order, into `out`, which is as long. Where rays go
  /// together, those of points that follow each other do: neighbours should. No meaningful values once
  /// cancelled.
  void radiances(std::span<const ScreenPoint> points, std::span<Color> out);

  const Job& job() const { return job_; }
  Stats& stats() { return tracer_.stats(); }

 private:
  void trace_together(std::span<const ScreenPoint> points, std::span<Color> out);
  Ray ray(ScreenPoint at);

  const Job& job_;
  Tracer tracer_;
  std::optional<BlockTracer> block_;
};

}  // namespace lancer::tracer
