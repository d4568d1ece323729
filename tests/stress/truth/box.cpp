#include "stress/truth/box.hpp"

#include <cmath>
#include <optional>

#include "stress/truth/exact_sign.hpp"

namespace lancer::stress::flat {
namespace {

/// A ray and a box, asked for the ray's place and slope along the box's axes.
struct Question {
  const BoxNumbers& box;
  Vec3 origin, direction;

  Vec3 row(int axis) const { return box.to_own[static_cast<std::size_t>(axis)]; }

  template <class Number>
  Number place(int axis) const {
    if (!box.turned) return Number(origin[axis]);
    return dot(as<Number>(row(axis)), as<Number>(origin) - as<Number>(box.center));
  }
  template <class Number>
  Number slope(int axis) const {
    if (!box.turned) return Number(direction[axis]);
    return dot(as<Number>(row(axis)), as<Number>(direction));
  }
  double level(int axis, bool upper) const { return upper ? box.hi[axis] : box.lo[axis]; }
  template <class Number>
  Number gap(int axis, bool upper) const {
    return Number(level(axis, upper)) - place<Number>(axis);
  }
};

/// A side whose plane the ray crosses, with the sign of its slope.
struct Side {
  int axis = 0;
  bool upper = false;
  int slope = 0;
};

int gap_sign(const Question& q, int axis, bool upper) {
  return exact_sign([&]<class Number>(Number) { return q.gap<Number>(axis, upper); });
}

/// The sign of the distance of side a less that of side b.
int compare(const Question& q, const Side& a, const Side& b) {
  return a.slope * b.slope * exact_sign([&]<class Number>(Number) {
           return Number(q.gap<Number>(a.axis, a.upper) * q.slope<Number>(b.axis) -
                         q.gap<Number>(b.axis, b.upper) * q.slope<Number>(a.axis));
         });
}

struct Span {
  std::optional<Side> enter, leave;
  bool missed = false;
};

Span span(const Question& q) {
  Span out;
  for (int axis = 0; axis < 3; ++axis) {
    const int slope = exact_sign([&]<class Number>(Number) { return q.slope<Number>(axis); });
    if (slope == 0) {
      out.missed = out.missed || gap_sign(q, axis, false) > 0 || gap_sign(q, axis, true) < 0;
      continue;
    }
    const Side in{axis, slope < 0, slope}, leaving{axis, slope > 0, slope};
    if (!out.enter || compare(q, in, *out.enter) > 0) out.enter = in;
    if (!out.leave || compare(q, leaving, *out.leave) < 0) out.leave = leaving;
  }
  out.missed = out.missed || !out.enter || compare(q, *out.enter, *out.leave) > 0;
  return out;
}

bool ahead(const Question& q, const Side& side) {
  return gap_sign(q, side.axis, side.upper) * side.slope > 0;
}

/// A quantity with the bound of what changes by 4 ulp may do to it.
struct Doubtful {
  double value = 0, doubt = 0;
  bool known() const { return std::fabs(value) > doubt; }
};
Doubtful operator*(const Doubtful& a, const Doubtful& b) {
  return {a.value * b.value, std::fabs(a.value) * b.doubt + std::fabs(b.value) * a.doubt + a.doubt * b.doubt};
}
Doubtful operator-(const Doubtful& a, const Doubtful& b) { return {a.value - b.value, a.doubt + b.doubt}; }

double spread(Vec3 a, Vec3 by) {
  return std::fabs(a.x) * by.x + std::fabs(a.y) * by.y + std::fabs(a.z) * by.z;
}

Doubtful doubtful_gap(const Question& q, int axis, bool upper) {
  const double level = four_ulp({q.level(axis, upper), 0, 0}).x;
  Doubtful gap{to_double(q.gap<Real>(axis, upper)), level};
  if (!q.box.turned) {
    gap.doubt += four_ulp(q.origin)[axis];
  } else {
    gap.doubt += spread(q.row(axis), four_ulp(q.origin) + four_ulp(q.box.center)) +
                 spread(q.origin - q.box.center, four_ulp(q.row(axis)));
  }
  return gap;
}

Doubtful doubtful_slope(const Question& q, int axis) {
  Doubtful slope{to_double(q.slope<Real>(axis)), 0};
  slope.doubt = q.box.turned
                    ? spread(q.row(axis), four_ulp(q.direction)) + spread(q.direction, four_ulp(q.row(axis)))
                    : four_ulp(q.direction)[axis];
  return slope;
}

/// The distance of side a less that of side b, times the slopes.
Doubtful doubtful_order(const Question& q, const Side& a, const Side& b) {
  const Doubtful ab = doubtful_gap(q, a.axis, a.upper) * doubtful_slope(q, b.axis);
  const Doubtful ba = doubtful_gap(q, b.axis, b.upper) * doubtful_slope(q, a.axis);
  Doubtful order = ab - ba;
  // Too near 0 for the exact difference to show in doubles of the products.
  order.value = to_double(q.gap<Real>(a.axis, a.upper) * q.slope<Real>(b.axis) -
                          q.gap<Real>(b.axis, b.upper) * q.slope<Real>(a.axis));
  return order;
}

Truth truth_at(const Question& q, const Side& side, bool entering) {
  Truth truth;
  truth.hit = true;
  truth.entering = entering;
  truth.face = 2 * side.axis + (side.upper ? 1 : 0);
  truth.t = q.gap<Real>(side.axis, side.upper) / q.slope<Real>(side.axis);
  truth.point = real(q.origin) + real(q.direction) * truth.t;
  Vec3 axis;
  axis[side.axis] = 1;
  truth.normal = normalized(real(q.box.turned ? q.row(side.axis) : axis) * Real(side.upper ? 1 : -1));
  return truth;
}

}  // namespace

Truth box_truth(const BoxNumbers& box, Vec3 origin, Vec3 direction) {
  const Question q{box, origin, direction};
  const Span met = span(q);
  if (met.missed) return {};
  if (ahead(q, *met.enter)) return truth_at(q, *met.enter, true);
  return ahead(q, *met.leave) ? truth_at(q, *met.leave, false) : Truth{};
}

Truth box_way_out(const BoxNumbers& box, Vec3 origin, Vec3 direction) {
  const Question q{box, origin, direction};
  const Span met = span(q);
  return met.missed || !ahead(q, *met.leave) ? Truth{} : truth_at(q, *met.leave, false);
}

bool box_in_band(const BoxNumbers& box, Vec3 origin, Vec3 direction) {
  const Question q{box, origin, direction};
  for (int axis = 0; axis < 3; ++axis) {
    if (doubtful_slope(q, axis).known()) continue;
    // All but parallel to the sides: what matters is on which side of them it runs.
    for (const bool upper : {false, true}) {
      if (!doubtful_gap(q, axis, upper).known()) return true;
    }
  }
  const Span met = span(q);
  if (!met.enter) return true;
  const auto doubtful = [&](const Side& a, const Side& b) {
    return a.axis != b.axis && !doubtful_order(q, a, b).known();
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int slope = exact_sign([&]<class Number>(Number) { return q.slope<Number>(axis); });
    if (slope == 0) continue;
    const Side in{axis, slope < 0, slope}, leaving{axis, slope > 0, slope};
    if (doubtful(in, *met.enter) || doubtful(in, *met.leave) || doubtful(leaving, *met.enter) ||
        doubtful(leaving, *met.leave)) {
      return true;
    }
  }
  return !doubtful_gap(q, met.enter->axis, met.enter->upper).known() ||
         !doubtful_gap(q, met.leave->axis, met.leave->upper).known();
}

}  // namespace lancer::stress::flat
