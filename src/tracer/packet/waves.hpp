#pragma once
// Rays in waves: how they look, and which of those that wait are traced next.

#include <memory>
#include <vector>

#include "tracer/packet/wave.hpp"

namespace lancer::tracer {

struct Rays {
  std::size_t count = 0;
  Vec3s origin, direction;
  Starts starts;
  Exits exits;
  Vec3s normal;               // of what it leaves, outward
  Column<std::uint8_t> face;  // of that, where it is a box
  Colors share;
  Column<std::uint32_t> term;  // that it brings
  bool from_eye = false;       // they start on nothing; `starts`, `normal` and `face` are not set
  int level = 0;               // how often they have turned off
};

/// The waves that wait, by the deviations of their rays and by whether they were reflected or let through, as
/// those that are alike stay near each other.
class Waves {
 public:
  /// The wave to which the next such ray is added; never full.
  Rays& room(int level, bool transmitted);
  /// The one to be traced next: full ones first, of these the deepest, so that only a few of a level wait;
  /// then the shallowest. Null: none is left.
  std::unique_ptr<Rays> take();
  /// Its room is used again.
  void give_back(std::unique_ptr<Rays> wave) { free_.push_back(std::move(wave)); }

 private:
  std::vector<std::vector<std::unique_ptr<Rays>>> waiting_;  // 2 level, + 1 for those let through
  std::vector<std::unique_ptr<Rays>> free_;
};

}  // namespace lancer::tracer
