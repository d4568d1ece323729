#pragma once
// The pixels of a block drawn together: one ray a pixel at a time, all of them searched, landed and lit four
// by four, then all rays that are reflected, and so on. What a ray sees is the same, bit for bit, as when it
// is traced by itself, and what needs more than the quick tests is traced so.

#include <memory>
#include <vector>

#include "tracer/camera.hpp"
#include "tracer/packet/hits.hpp"
#include "tracer/packet/scenery.hpp"
#include "tracer/radiance.hpp"

namespace lancer::tracer {

class BlockTracer {
 public:
  /// Draws with `single` what goes one by one; its statistics have all that is done.
  BlockTracer(const PacketWorld& packets, const Tracing& tracing, Tracer& single);
  ~BlockTracer();

  /// Forgets all rays.
  void clear() { rays_->count = 0; }
  /// Of these no more than k_wave.
  void add_ray(const CameraRay& ray, std::size_t pixel);
  std::size_t size() const { return rays_->count; }

  /// Adds what arrives along the rays to the sums at their pixels, and forgets the rays. No meaningful values
  /// once cancelled.
  void add_radiance(int depth, Color* sums);

 private:
  void sort_found(int depth);
  void land(int depth);
  void add_hits(int depth);
  void reflect(int depth);
  /// Follows the ray, with all that comes of it, by itself.
  void follow_alone(std::size_t ray, int depth);

  const PacketWorld& packets_;
  Tracing tracing_;
  Tracer& single_;
  std::unique_ptr<Rays> rays_, next_;
  std::unique_ptr<FirstHits> found_;
  std::unique_ptr<Hits> hits_;
  std::unique_ptr<Lighting> lighting_;
  Color* sums_ = nullptr;
  bool from_eye_ = true;
};

}  // namespace lancer::tracer
