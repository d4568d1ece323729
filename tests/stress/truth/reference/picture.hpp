#pragma once
// True pictures: the linear radiance at each pixel's centre, and whether a pixel's truth may be told at all.

#include <vector>

#include "tracer.hpp"

namespace lancer::reference {

/// Where a ray of a view starts and where it goes; the direction of any length.
struct Sight {
  Vector origin, direction;
};

/// Through the point x columns from the left and y rows from the top; pixel (i, j) has its centre at
/// (i + 1/2, j + 1/2).
Sight sight(const scene::View& view, const Real& x, const Real& y);

class Picture {
 public:
  Picture(const scene::Scene& scene, const scene::View& view, Tolerance tolerance = {});

  /// Pixels are seen at (i + x, j + y) in place of their centres: other tracers look at their corners.
  void look_at(double x, double y) { x_ = x, y_ = y; }

  int columns() const { return view_.columns; }
  int rows() const { return view_.rows; }

  Color pixel(int column, int row);
  /// Do rays moved by 1e-7 of a pixel and by 4 ulp of the eye's coordinates meet other things and bring back
  /// another colour, by more than a tenth of the limit?
  bool at_edge(int column, int row, double limit);
  /// Does the colour change, smoothly but by more than the limit, where eye and direction are moved by 4 ulp?
  bool sensitive(int column, int row, double limit);
  /// Is the pixel's truth within the limit only by the grace of rounding?
  bool ambiguous(int column, int row, double limit) {
    return at_edge(column, row, limit) || sensitive(column, row, limit);
  }
  /// Does the pixel change by more than the limit where what counts as coincident or as a boundary is an
  /// eighth as wide, or eight times? So where things lie near each other, but not by chance, it is no excuse.
  bool hangs_on_tolerance(int column, int row, double limit);

 private:
  Color at(Tracer& tracer, const Sight& from) const;
  /// The largest change of colour over rays moved by so much of a pixel, of the eye's coordinates and of the
  /// direction; of those only that take another course, where that is asked for.
  struct Shake {
    Real pixels, eye, direction;
    bool other_course_only = false;
  };
  double spread(int column, int row, const Shake& shake);

  const scene::Scene& scene_;
  const scene::View& view_;
  Tolerance tolerance_;
  Tracer tracer_;
  double x_ = 0.5, y_ = 0.5;
};

/// The largest difference of two colours' components.
double difference(const Color& a, const Color& b);

}  // namespace lancer::reference
