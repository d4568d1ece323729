#include "picture.hpp"

#include <algorithm>
#include <cmath>

namespace lancer::reference {
namespace {

const Real k_ulps = Real(4) * 0x1p-52;

double nearest(const Real& value) { return value.convert_to<double>(); }

}  // namespace

double difference(const Color& a, const Color& b) {
  const double worst = std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
  // What is no number differs from everything.
  return worst == worst && a.r == a.r && a.g == a.g && a.b == a.b ? worst : HUGE_VAL;
}

Sight sight(const scene::View& view, const Real& x, const Real& y) {
  const Vector eye = exact(view.eye) + exact(view.eye_rest);
  const Real w = view.columns, h = view.rows;
  if (view.projection == scene::Projection::corners) {
    const auto corner = [&](std::size_t i) { return exact(view.corners[i]) + exact(view.corner_rests[i]); };
    const Vector a = corner(0), b = corner(1), c = corner(2);
    return {eye, a + (b - a) * (x / w) + (c - a) * (y / h) - eye};
  }
  const Vector f = unit(exact(view.look));
  const Vector r = unit(cross(f, exact(view.up)));
  const Vector u = cross(r, f);
  const bool parallel = view.projection == scene::Projection::orthographic;
  const Real half = parallel ? Real(view.width) / 2 : Real(tan(radians(Real(view.fov) / 2)));
  const Vector offset = r * ((2 * x / w - 1) * half) - u * ((2 * y / h - 1) * half * h / w);
  if (parallel) return {eye + offset, f};
  return {eye, f + offset};
}

Picture::Picture(const scene::Scene& scene, const scene::View& view, Tolerance tolerance)
    : scene_(scene), view_(view), tolerance_(tolerance), tracer_(scene, tolerance) {}

Color Picture::at(Tracer& tracer, const Sight& from) const {
  tracer.reset_course();
  const Radiance c = tracer.radiance(tracer.from_eye(from.origin, from.direction), scene_.settings.depth);
  return {nearest(c.r), nearest(c.g), nearest(c.b)};
}

Color Picture::pixel(int column, int row) {
  return at(tracer_, sight(view_, Real(column) + x_, Real(row) + y_));
}

double Picture::spread(int column, int row, const Shake& shake) {
  const Real x = Real(column) + x_, y = Real(row) + y_;
  const Color here = at(tracer_, sight(view_, x, y));
  const std::uint64_t course = tracer_.course();
  double worst = 0;
  for (int k = 0; k < 8; ++k) {
    // The eight neighbours, and the eight corners of a box.
    const int place = k < 4 ? k : k + 1;
    const int dx = place % 3 - 1, dy = place / 3 - 1;
    const int sx = k & 1 ? 1 : -1, sy = k & 2 ? 1 : -1, sz = k & 4 ? 1 : -1;
    Sight from = sight(view_, x + shake.pixels * dx, y + shake.pixels * dy);
    const Vector& o = from.origin;
    const Real eye_x = abs(o.x) * shake.eye, eye_y = abs(o.y) * shake.eye, eye_z = abs(o.z) * shake.eye;
    from.origin = o + Vector{eye_x * sx, eye_y * sy, eye_z * sz};
    const Real way = largest(from.direction) * shake.direction;
    from.direction = from.direction + Vector{way * sx, way * sy, way * sz};
    const Color there = at(tracer_, from);
    if (!shake.other_course_only || tracer_.course() != course)
      worst = std::max(worst, difference(here, there));
  }
  return worst;
}

bool Picture::at_edge(int column, int row, double limit) {
  return spread(column, row, {Real("1e-7"), k_ulps, 0, true}) > limit / 10;
}

bool Picture::sensitive(int column, int row, double limit) {
  return spread(column, row, {0, k_ulps, 0, false}) + spread(column, row, {0, 0, k_ulps, false}) > limit;
}

bool Picture::hangs_on_tolerance(int column, int row, double limit) {
  const Sight from = sight(view_, Real(column) + x_, Real(row) + y_);
  const Color here = at(tracer_, from);
  for (const double factor : {0.125, 8.0}) {
    Tracer coincident(scene_, {tolerance_.coincident * factor, tolerance_.boundary});
    Tracer boundary(scene_, {tolerance_.coincident, tolerance_.boundary * factor});
    if (difference(here, at(coincident, from)) > limit || difference(here, at(boundary, from)) > limit)
      return true;
  }
  return false;
}

}  // namespace lancer::reference
