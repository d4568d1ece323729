#pragma once
// The pixels of a block drawn together: one ray a pixel at a time, all of them searched, landed and lit four
// by four, then all rays that go on from there, and so on. What a ray sees is the same, bit for bit, as when
// it is traced by itself, and what needs more than the quick tests is traced so.

#include <memory>
#include <span>
#include <vector>

#include "tracer/camera.hpp"
#include "tracer/packet/hits.hpp"
#include "tracer/packet/light_tree.hpp"
#include "tracer/packet/scenery.hpp"
#include "tracer/radiance.hpp"

namespace lancer::tracer {

class BlockTracer {
 public:
  /// Draws with `single` what goes one by one; its statistics have all that is done.
  BlockTracer(const PacketWorld& packets, const Tracing& tracing, Tracer& single);
  ~BlockTracer();

  /// Adds the rays through the points, no more than k_wave.
  void add_rays(const Camera& camera, std::span<const ScreenPoint> points);
  /// What arrives along the rays, in their order; then they are forgotten. No meaningful values once
  /// cancelled.
  void radiances(int depth, std::span<Color> out);

 private:
  void trace(Rays& rays);
  void sort_found();
  /// Makes hits of the rays at those places; only the first `there` of them are.
  void add_found(std::span<const std::uint16_t> from, std::size_t there);
  void land();
  void land_others();
  void add_hits();
  /// Finds where light goes on from the hits, and how much.
  void go_on();
  void bend();
  void turn_off(Turned& turned, const Words& open, bool transmitted);
  void add_turned(Rays& next, const Turned& turned, std::span<const std::uint16_t> from, bool transmitted);
  void add_late(const Turned& turned, std::size_t hit, bool transmitted);
  void add_late(Pending ray, std::uint32_t term);

  /// Traces a ray of the wave by itself; what goes on from there goes with others again, where it can.
  void trace_alone(std::size_t ray);
  void trace_alone(Pending ray, std::uint32_t term);
  void add_branch(std::optional<Branch>& branch, const Pending& from, std::uint32_t surface,
                  bool transmitted);
  /// False: it has more to remember than rays that go together can.
  bool rejoin(const Pending& ray, std::uint32_t term, bool transmitted);

  /// Places in a wave.
  struct Places {
    std::size_t count = 0;
    std::array<std::uint16_t, k_wave + k_group> at;
  };
  /// A ray to be traced by itself.
  struct Lone {
    Pending ray;
    std::uint32_t term = 0;
  };

  const PacketWorld& packets_;
  Tracing tracing_;
  Tracer& single_;
  OpenLists lists_;
  Waves waves_;
  LightTree terms_;
  std::unique_ptr<FirstHits> found_;
  std::unique_ptr<Hits> hits_;
  std::unique_ptr<Lighting> lighting_;
  std::unique_ptr<Onward> onward_;
  std::vector<Lone> lone_;
  std::vector<Pending> late_;  // that are followed when the sums are made
  Rays* rays_ = nullptr;       // those being traced
  int depth_ = 0;              // of the scene
};

}  // namespace lancer::tracer
