#include "stress/truth/first_hit.hpp"

#include <array>
#include <limits>

namespace lancer::stress {
namespace {

/// How far the numbers of the input may be changed to find out whether the answer hangs on their rounding.
constexpr double k_band = 4;

double band_of(double value) {
  const double size = std::fabs(value);
  return k_band * (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
}

/// The points x with |rows (x - center)| = radius.
struct Round {
  Vec3 center;
  std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  double radius = 1;
  bool mapped = false;  // the rows are numbers of the input; else the radius is one
};

/// The solid's own space: from the centre to the origin, the direction, and the terms of the equation
/// a t^2 - 2 b t + c = 0, with inside = b^2 - a c.
template <class Number>
struct Equation {
  Triple<Number> from, along;
  Number a, b, c, inside;

  Equation(const Round& round, const Sight& sight) {
    const Triple<Number> offset = as<Number>(sight.origin) - as<Number>(round.center);
    const Triple<Number> direction = as<Number>(sight.direction);
    for (int i = 0; i < 3; ++i) {
      const Triple<Number> row = as<Number>(round.rows[static_cast<std::size_t>(i)]);
      from[i] = dot(row, offset);
      along[i] = dot(row, direction);
    }
    const Number r(round.radius);
    const Triple<Number> moment = cross(from, along);
    a = dot(along, along);
    b = -dot(from, along);
    c = dot(from, from) - r * r;
    inside = r * r * a - dot(moment, moment);
  }
};

template <class Number>
int sign(const Number& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

struct Signs {
  int b = 0, c = 0, inside = 0;
};

/// Of the equation's terms. Where those of `Real` are too near 0 to be sure of, they are worked out exactly.
Signs signs_of(const Equation<Real>& e, const Round& round, const Sight& sight) {
  const Real size = dot(e.from, e.from) + Real(round.radius) * Real(round.radius);
  const auto sure = [](const Real& value, const Real& of) { return abs(value) > ldexp(of, -600); };
  if (sure(e.b * e.b, size * e.a) && sure(e.c, size) && sure(e.inside, size * e.a)) {
    return {sign(e.b), sign(e.c), sign(e.inside)};
  }
  const Equation<Exact> exact(round, sight);
  return {sign(exact.b), sign(exact.c), sign(exact.inside)};
}

/// A vector of the world, and how far each of its components may be changed.
struct Banded {
  Vec3 value, band;
};

Banded start_of(const Round& round, const Sight& sight) {
  Banded out{to_vec3(real(sight.origin) - real(round.center)), {}};
  for (int j = 0; j < 3; ++j) out.band[j] = band_of(sight.origin[j]) + band_of(round.center[j]);
  return out;
}

Banded direction_of(const Sight& sight) {
  Banded out{sight.direction, {}};
  for (int j = 0; j < 3; ++j) out.band[j] = band_of(sight.direction[j]);
  return out;
}

/// The most by which form . (rows v) moves where its numbers do, to first order.
double most_change(const Round& round, const Real3& form, const Banded& v) {
  const Vec3 n = to_vec3(form);
  double change = 0;
  for (int j = 0; j < 3; ++j) {
    double slope = 0, rows = 0;
    for (int i = 0; i < 3; ++i) {
      const double entry = round.rows[static_cast<std::size_t>(i)][j];
      slope += n[i] * entry;
      rows += std::fabs(n[i]) * band_of(entry);
    }
    change += std::fabs(slope) * v.band[j];
    if (round.mapped) change += rows * std::fabs(v.value[j]);
  }
  return change;
}

bool hangs_on_rounding(const Round& round, const Sight& sight, const Equation<Real>& e, const Signs& signs) {
  const Banded start = start_of(round, sight), direction = direction_of(sight);
  const double radius = round.mapped ? 0 : band_of(round.radius);
  if (sight.from_surface) {
    return abs(e.b) <= most_change(round, e.along, start) + most_change(round, e.from, direction);
  }
  const Real size = length(e.from);
  if (size == 0) return false;
  if (abs(size - Real(round.radius)) <= most_change(round, e.from / size, start) + radius) return true;
  if (signs.c <= 0 || signs.b <= 0) return false;
  const Real way = e.b / e.a;
  const Real3 nearest = e.from + e.along * way;
  const Real distance = length(nearest);
  if (distance == 0) return false;
  const double t = to_double(way);
  const Banded there{start.value + direction.value * t, start.band + direction.band * t};
  return abs(distance - Real(round.radius)) <= most_change(round, nearest / distance, there) + radius;
}

/// Which root is met; false: none.
bool choose(const Sight& sight, const Signs& signs, Truth& truth) {
  if (sight.from_surface) {
    if (signs.b <= 0) return false;
    truth.open = signs.inside < 0;
    truth.entering = false;
    return !truth.open;
  }
  if (signs.inside < 0) return false;
  truth.entering = signs.c > 0;
  return signs.c < 0 || signs.b > 0;
}

Truth first_hit(const Round& round, const Sight& sight) {
  const Equation<Real> e(round, sight);
  const Signs signs = signs_of(e, round, sight);
  Truth truth;
  truth.hit = choose(sight, signs, truth);
  truth.in_band = hangs_on_rounding(round, sight, e, signs);
  // No further than through a solid that is larger or smaller by what rounding took from the start.
  if (truth.open) truth.t = 4 * (e.b / e.a + sqrt(abs(e.c) / e.a));
  if (!truth.hit) return truth;
  const Real root = signs.inside == 0 ? Real(0) : Real(sqrt(e.inside));
  const bool forward = signs.b >= 0;
  const Real q = forward ? e.b + root : e.b - root;  // without cancellation
  const bool is_far = !truth.entering;
  truth.t = is_far == forward ? q / e.a : e.c / q;
  truth.point = real(sight.origin) + real(sight.direction) * truth.t;
  const Real3 own = e.from + e.along * truth.t;
  for (int j = 0; j < 3; ++j) {
    truth.normal[j] = own.x * round.rows[0][j] + own.y * round.rows[1][j] + own.z * round.rows[2][j];
  }
  truth.normal = normalized(truth.normal);
  return truth;
}

/// depth / slope is where the ray meets the plane.
template <class Number>
struct PlaneTerms {
  Number depth, slope;

  PlaneTerms(const tracer::PlanePrimitive& plane, const Sight& sight) {
    const Triple<Number> normal = as<Number>(plane.normal);
    depth = Number(plane.level) - dot(normal, as<Number>(sight.origin) - as<Number>(plane.point));
    slope = dot(normal, as<Number>(sight.direction));
  }
  /// The sizes of what is added up.
  static PlaneTerms sizes(const tracer::PlanePrimitive& plane, const Sight& sight) {
    PlaneTerms out = {plane, sight};
    out.depth = abs(Number(plane.level));
    out.slope = 0;
    for (int i = 0; i < 3; ++i) {
      const Number n = abs(Number(plane.normal[i]));
      out.depth += n * (abs(Number(sight.origin[i])) + abs(Number(plane.point[i])));
      out.slope += n * abs(Number(sight.direction[i]));
    }
    return out;
  }
};

/// To far more digits than a double has; 0 where they are 0.
PlaneTerms<Real> terms_of(const tracer::PlanePrimitive& plane, const Sight& sight) {
  PlaneTerms<Real> terms(plane, sight);
  const PlaneTerms<Real> sizes = PlaneTerms<Real>::sizes(plane, sight);
  if (abs(terms.depth) > ldexp(sizes.depth, -400) && abs(terms.slope) > ldexp(sizes.slope, -400))
    return terms;
  const PlaneTerms<Exact> exact(plane, sight);
  terms.depth = exact.depth.convert_to<Real>();
  terms.slope = exact.slope.convert_to<Real>();
  return terms;
}

bool hangs_on_rounding(const tracer::PlanePrimitive& plane, const Sight& sight,
                       const PlaneTerms<Real>& terms) {
  double slope = 0, depth = band_of(plane.level);
  for (int i = 0; i < 3; ++i) {
    const double n = std::fabs(plane.normal[i]), d = std::fabs(sight.direction[i]);
    slope += n * band_of(d) + d * band_of(n);
    const double offset = std::fabs(to_double(Real(sight.origin[i]) - Real(plane.point[i])));
    depth += n * (band_of(sight.origin[i]) + band_of(plane.point[i])) + offset * band_of(n);
  }
  return abs(terms.slope) <= slope || (!sight.from_surface && abs(terms.depth) <= depth);
}

}  // namespace

Truth first_hit(const tracer::SpherePrimitive& sphere, const Sight& sight) {
  Round round;
  round.center = sphere.center;
  round.radius = sphere.radius;
  return first_hit(round, sight);
}

Truth first_hit(const tracer::EllipsoidPrimitive& ellipsoid, const Sight& sight) {
  Round round;
  round.center = ellipsoid.center;
  round.rows = ellipsoid.to_own;
  round.mapped = true;
  return first_hit(round, sight);
}

Truth first_hit(const tracer::PlanePrimitive& plane, const Sight& sight) {
  const PlaneTerms<Real> terms = terms_of(plane, sight);
  Truth truth;
  truth.in_band = hangs_on_rounding(plane, sight, terms);
  truth.entering = terms.slope < 0;
  if (sight.from_surface || sign(terms.depth) * sign(terms.slope) <= 0) return truth;
  truth.t = terms.depth / terms.slope;
  if (truth.t > Real(std::numeric_limits<double>::max())) return truth;
  truth.hit = true;
  truth.point = real(sight.origin) + real(sight.direction) * truth.t;
  truth.normal = normalized(real(plane.normal));
  return truth;
}

}  // namespace lancer::stress
