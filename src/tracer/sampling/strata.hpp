#pragma once
// A pixel cut into squares, each with one sample at random in it, smaller where neighbours differ. What is
// cut and what is left is decided from few samples, so a part of the trust goes to what is usual around: that
// makes it less than the most thrifty way along an edge, and honest where there is noise.

#include <array>
#include <span>
#include <vector>

#include "tracer/sampling/demand.hpp"
#include "tracer/sampling/lattice.hpp"
#include "tracer/sampling/stratum.hpp"

namespace lancer::tracer {

class Strata {
 public:
  void begin(const PixelKey& pixel, const Surroundings& around);

  /// Cuts further where the error asked for wants it, and puts the points whose light must be known behind
  /// those in `points`. False: nothing is wanted any more.
  bool refine(const Demand& demand, std::vector<ScreenPoint>& points);
  /// The light at the points that were wanted last.
  void take(std::span<const Color> colors);

  std::size_t wanted() const { return wanted_; }
  Color mean() const;

 private:
  struct Leaf {
    Stratum square;
    ScreenPoint at;  // from the pixel's corner
    Color color;
    Color differences;  // from its neighbours, mean square
    Color spread;       // a variance: what the leaf adds to that of the mean, linear
    double weight = 0;  // the same in display units, squared
  };

  void cut(std::size_t leaf, std::vector<ScreenPoint>& points);
  void draw_map();
  Color differences_of(std::size_t leaf) const;
  Color measure_spread();
  /// How far off the mean is estimated to be, display units; sets the leaves' weights.
  double estimate(const Display& display);

  PixelKey pixel_{0, 0};
  std::array<Color, 4> corners_;
  Color around_;  // mean square of the differences in the first look
  std::vector<Leaf> leaves_;
  std::size_t wanted_ = 0;          // the last leaves, whose colour is not known yet
  int deepest_ = 0;                 // level of the smallest leaf
  std::vector<std::uint16_t> map_;  // for each square of that level the leaf that it lies in
};

}  // namespace lancer::tracer
