#pragma once
// A pixel that one straight edge runs through: where it enters and leaves is found by bisection on the
// pixel's sides, and the mean follows from the areas. The error of n samples falls like 2^(-n/2). Whether it
// is such a pixel is doubted all the way: every sample must be like one of two sides, the edge must not be
// bent in the middle, and the samples of the first look in and around the pixel must lie on the right sides.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "tracer/sampling/demand.hpp"
#include "tracer/sampling/lattice.hpp"
#include "tracer/sampling/stratum.hpp"

namespace lancer::tracer {

class Edge {
 public:
  void begin(const PixelKey& pixel, const Surroundings& around, const Demand& demand);

  enum class State {
    asking,  // for the light at the points
    found,   // mean() is the pixel's
    other,   // it is no such pixel
  };
  /// Puts the points whose light must be known behind those in `points`.
  State refine(const Demand& demand, std::vector<ScreenPoint>& points);
  /// The light at the points that were wanted last.
  void take(std::span<const Color> colors);

  std::size_t wanted() const { return wanted_; }
  Color mean() const { return mean_; }

 private:
  enum class Side : std::uint8_t { a, b, neither };
  /// A side of the pixel that the edge crosses: between these two places.
  struct Crossing {
    ScreenPoint a, b;
    Color at_a, at_b;
    double width = 1;

    ScreenPoint middle() const { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
  };

  Side side_of(Color color) const;
  bool find_sides(const std::array<Color, 4>& corners);
  void want(ScreenPoint at, std::vector<ScreenPoint>& points);
  double loss(double area, const Display& display) const;
  bool bisect(const Demand& demand, std::vector<ScreenPoint>& points);
  void check_middle(std::vector<ScreenPoint>& points);
  double area_of_a() const;
  bool goes_on_around() const;
  std::optional<Color> light_on(Side side, double part, const Demand& demand) const;
  State conclude(const Demand& demand);

  PixelKey pixel_{0, 0};
  Surroundings surroundings_;
  Color a_, b_;                         // how the two sides look
  double allowed_ = 0;                  // the area that may be taken for the other side's
  std::array<Side, 4> labels_{};        // of the corners, clockwise from the upper left
  std::array<Color, 4> around_;         // the same
  std::array<Crossing, 2> crossings_;   // in the order of the sides, clockwise from the upper one
  std::array<std::size_t, 2> sides_{};  // that they are on
  enum class Stage : std::uint8_t { bisecting, checking, failed } stage_ = Stage::failed;
  std::size_t wanted_ = 0;
  std::array<std::size_t, 2> bisected_{};  // the crossings that wait for light
  Color mean_;
};

}  // namespace lancer::tracer
