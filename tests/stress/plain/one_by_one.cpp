// A plain tracer has no kernels for four rays: it traces those that would go together one by one.

#include "tracer/packet/block.hpp"

namespace lancer::tracer {

PacketWorld::PacketWorld(const World&, const Plan&) {}
OpenLists::OpenLists(const World& world) : world_(world) {}

BlockTracer::BlockTracer(const PacketWorld& packets, const Tracing& tracing, Tracer& single)
    : packets_(packets), tracing_(tracing), single_(single), lists_(*tracing.world) {}

BlockTracer::~BlockTracer() = default;

void BlockTracer::add_rays(const Camera& camera, std::span<const ScreenPoint> points) {
  for (const ScreenPoint& point : points) {
    const CameraRay ray = camera.ray(point.x, point.y);
    late_.push_back({{ray.origin, ray.direction, 0, {}, {}}, grey(1), 0});
  }
}

void BlockTracer::radiances(int depth, std::span<Color> out) {
  for (std::size_t i = 0; i < out.size() && !tracing_.cancelled(); ++i) {
    out[i] = {};
    single_.follow(late_[i].ray, late_[i].share, depth, out[i]);
  }
  late_.clear();
}

}  // namespace lancer::tracer
