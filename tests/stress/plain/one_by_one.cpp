// A plain tracer has no kernels for four rays: it traces those that would go together one by one.

#include "tracer/packet/block.hpp"

namespace lancer::tracer {

PacketWorld::PacketWorld(const World&, ShadowWork) {}

BlockTracer::BlockTracer(const PacketWorld& packets, const Tracing& tracing, Tracer& single)
    : packets_(packets), tracing_(tracing), single_(single), rays_(std::make_unique<Rays>()) {}

BlockTracer::~BlockTracer() = default;

void BlockTracer::add_ray(const CameraRay& ray, std::size_t pixel) {
  const std::size_t i = rays_->count++;
  rays_->origin.set(i, ray.origin);
  rays_->direction.set(i, ray.direction);
  rays_->pixel[i] = static_cast<std::uint16_t>(pixel);
}

void BlockTracer::add_radiance(int depth, Color* sums) {
  for (std::size_t i = 0; i < rays_->count && !tracing_.cancelled(); ++i) {
    const Ray ray{rays_->origin[i], rays_->direction[i], 0, {}, {}};
    single_.follow(ray, grey(1), depth, sums[rays_->pixel[i]]);
  }
}

}  // namespace lancer::tracer
