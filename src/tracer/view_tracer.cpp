#include "tracer/view_tracer.hpp"

namespace lancer::tracer {

void ViewTracer::radiances(std::span<const ScreenPoint> points, std::span<Color> out) {
  const int depth = job_.tracing.world->scene->settings.depth;
  for (std::size_t i = 0; i < points.size() && !job_.tracing.cancelled(); ++i) {
    out[i] = tracer_.radiance(ray(points[i]), depth);
    ++tracer_.stats().primary_rays;
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
