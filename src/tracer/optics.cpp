#include "tracer/optics.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/numeric.hpp"

namespace lancer::tracer {
namespace {

/// The angles on both sides, as cosines scaled by `to`.
struct Angles {
  double cos_in = 1;         // of the arriving ray
  Vec3 along;                // the part of d along the surface
  double scaled_square = 1;  // (to cos_out)^2, negative under total reflection
};

Angles angles(Vec3 d, Vec3 n, double from, double to) {
  Angles a;
  a.cos_in = std::clamp(-dot(d, n), 0.0, 1.0);
  a.along = d + n * a.cos_in;
  // to^2 - from^2 sin^2 by whichever of the two is the smaller and so the better known.
  if (a.cos_in < 0.7) {
    const double cosine = from * a.cos_in;
    a.scaled_square = (to - from) * (to + from) + cosine * cosine;
  } else {
    const double sine = from * std::sqrt(dot(a.along, a.along));
    a.scaled_square = (to - sine) * (to + sine);
  }
  return a;
}

}  // namespace

std::optional<Vec3> refracted(Vec3 d, Vec3 n, double from, double to) {
  if (from == to) return d;
  const Angles a = angles(d, n, from, to);
  if (a.scaled_square < 0) return std::nullopt;
  return normalize(a.along * from - n * std::sqrt(a.scaled_square));
}

double fresnel(Vec3 d, Vec3 n, double from, double to) {
  if (from == to) return 0;
  const Angles a = angles(d, n, from, to);
  if (a.scaled_square < 0) return 1;
  const double cos_out = std::sqrt(a.scaled_square) / to;
  const double across = (from * a.cos_in - to * cos_out) / (from * a.cos_in + to * cos_out);
  const double within = (to * a.cos_in - from * cos_out) / (to * a.cos_in + from * cos_out);
  const double reflectance = (across * across + within * within) / 2;
  return std::isnan(reflectance) ? 1 : reflectance;
}

}  // namespace lancer::tracer
