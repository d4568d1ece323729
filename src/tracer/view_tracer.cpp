#include "tracer/view_tracer.hpp"

#include <algorithm>

namespace lancer::tracer {

void ViewTracer::radiances(std::span<const ScreenPoint> points, std::span<Color> out) {
  if (block_) return trace_together(points, out);
  const int depth = job_.tracing.world->scene->settings.depth;
  for (std::size_t i = 0; i < points.size() && !job_.tracing.cancelled(); ++i) {
    out[i] = tracer_.radiance(ray(points[i]), depth);
    ++tracer_.stats().primary_rays;
  }
}

void ViewTracer::trace_together(std::span<const ScreenPoint> points, std::span<Color> out) {
  const int depth = job_.tracing.world->scene->settings.depth;
  for (std::size_t first = 0; first < points.size() && !job_.tracing.cancelled(); first += 2 * k_wave) {
    const std::size_t count = std::min(points.size() - first, 2 * k_wave);
    block_->add_rays(job_.camera, points.subspan(first, count));
    tracer_.stats().primary_rays += count;
    block_->radiances(depth, out.subspan(first, count));
  }
}

Ray ViewTracer::ray(ScreenPoint at) {
  const CameraRay from = job_.camera.ray(at.x, at.y);
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

}  // namespace lancer::tracer
