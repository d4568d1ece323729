#pragma once
// As many samples in a pixel as the error asked for wants.

#include <vector>

#include "image/image.hpp"
#include "tracer/sampling/doubt.hpp"
#include "tracer/sampling/edge.hpp"
#include "tracer/sampling/lattice.hpp"
#include "tracer/sampling/strata.hpp"
#include "tracer/threads.hpp"

namespace lancer::tracer {

/// One thread's. A pixel that the first look settles has the mean of its corners. The others are refined, all
/// those of a tile in step, so that many rays are asked for at once.
class RefiningDrawer {
 public:
  /// `lattice` holds the first look at the job's region.
  RefiningDrawer(ViewTracer& tracer, const Lattice& lattice, const Demand& demand);

  /// Draws the pixels of a tile of the region; with nothing of use where the job is cancelled.
  void draw(const Tile& tile, image::Image& image);

 private:
  /// A pixel that is refined.
  struct Open {
    int column = 0, row = 0;  // in the view
    bool has_edge = true;     // as far as is known
    Edge edge;
    Strata strata;

    Color mean() const { return has_edge ? edge.mean() : strata.mean(); }
  };

  void settle(const Tile& in_view, image::Image& image);
  Open& next_open();
  bool refine(Open& pixel);
  void refine_all();

  ViewTracer& tracer_;
  const Lattice& lattice_;
  Demand demand_;
  Doubt doubt_;
  std::vector<Open> pixels_;  // the first `open_` of them; the others keep their memory
  std::size_t open_ = 0;
  std::vector<Open*> asking_;
  std::vector<ScreenPoint> points_;
  std::vector<Color> colors_;
};

}  // namespace lancer::tracer
