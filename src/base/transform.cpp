#include "base/transform.hpp"

#include <cmath>

#include "base/double_double.hpp"
#include "base/math.hpp"

namespace lancer {
namespace {

/// The same vector with 0 for -0, so that turns by 90 degrees leave no trace of the way they took.
Vec3 without_minus_zero(Vec3 v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

Affine linear(Vec3 row0, Vec3 row1, Vec3 row2) {
  return {{without_minus_zero(row0), without_minus_zero(row1), without_minus_zero(row2)}, {}};
}

Affine about_x(double angle) {
  const double s = math::sin_deg(angle), c = math::cos_deg(angle);
  return linear({1, 0, 0}, {0, c, -s}, {0, s, c});
}

Affine about_y(double angle) {
  const double s = math::sin_deg(angle), c = math::cos_deg(angle);
  return linear({c, 0, s}, {0, 1, 0}, {-s, 0, c});
}

Affine about_z(double angle) {
  const double s = math::sin_deg(angle), c = math::cos_deg(angle);
  return linear({c, -s, 0}, {s, c, 0}, {0, 0, 1});
}

/// 1 - cos(angle) without cancellation.
double versine(double angle, double cosine) {
  if (cosine <= 0.5) return 1 - cosine;
  const double half = math::sin_deg(angle / 2);
  return 2 * half * half;
}

DoubleDouble operator*(const std::array<DoubleDouble, 3>& v, Vec3 row) {
  return v[0] * row.x + v[1] * row.y + v[2] * row.z;
}

using Matrix = std::array<std::array<DoubleDouble, 3>, 3>;

/// A matrix whose rows have been divided by the powers of two that bring them near 1.
struct Scaled {
  std::array<Vec3, 3> rows;
  std::array<int, 3> exponents{};
};

std::optional<Scaled> scale_rows(const Affine& a) {
  Scaled out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 row = a.rows[i];
    if (max_abs(row) == 0) return std::nullopt;
    const int e = std::ilogb(max_abs(row));
    out.exponents[i] = e;
    out.rows[i] = times_power_of_two(row, -e);
  }
  return out;
}

/// a d - b c
DoubleDouble minor(double a, double b, double c, double d) { return two_product(a, d) - two_product(b, c); }

/// The matrix of cofactors, transposed.
Matrix adjugate(const std::array<Vec3, 3>& m) {
  Matrix out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 p = m[static_cast<std::size_t>((i + 1) % 3)];
      const Vec3 q = m[static_cast<std::size_t>((i + 2) % 3)];
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      out[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = minor(p[k], p[l], q[k], q[l]);
    }
  }
  return out;
}

/// The sum of the sizes of the six products that make the determinant.
double permanent(const std::array<Vec3, 3>& m) {
  const auto size = [&](std::size_t row, int column) { return std::fabs(m[row][column]); };
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    sum += size(0, i) * (size(1, k) * size(2, l) + size(1, l) * size(2, k));
  }
  return sum;
}

}  // namespace

Place Place::from(Vec3 origin) const {
  Place way;
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDouble difference = two_sum(at[axis], -origin[axis]) + rest[axis];
    way.at[axis] = difference.hi;
    way.rest[axis] = difference.lo;
  }
  return way;
}

Place Affine::place(const Place& p) const {
  std::array<DoubleDouble, 3> from;
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    from[i] = two_sum(p.at[axis], p.rest[axis]);
  }
  Place to;
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    const DoubleDouble moved = from * rows[i] + two_sum(translation[axis], rest[axis]);
    to.at[axis] = moved.hi;
    to.rest[axis] = moved.lo;
  }
  // Near the end of the range of numbers what twice the precision needs overflows first.
  return is_finite(to.at) && is_finite(to.rest) ? to : Place{point(p.at), {}};
}

std::array<Vec3, 3> near_one(const std::array<Vec3, 3>& rows, int& exponent) {
  exponent = std::ilogb(std::fmax(max_abs(rows[0]), std::fmax(max_abs(rows[1]), max_abs(rows[2]))));
  return {times_power_of_two(rows[0], -exponent), times_power_of_two(rows[1], -exponent),
          times_power_of_two(rows[2], -exponent)};
}

bool is_identity(const Affine& a) { return a == Affine{}; }

bool is_finite(const Affine& a) {
  return is_finite(a.rows[0]) && is_finite(a.rows[1]) && is_finite(a.rows[2]) && is_finite(a.translation);
}

double determinant(const Affine& a) { return dot(a.rows[0], cross(a.rows[1], a.rows[2])); }

Affine then(const Affine& first, const Affine& second) {
  Affine out;
  for (std::size_t i = 0; i < 3; ++i) out.rows[i] = without_minus_zero(first.transposed(second.rows[i]));
  const Place moved = second.place({first.translation, first.rest});
  out.translation = without_minus_zero(moved.at);
  out.rest = without_minus_zero(moved.rest);
  return out;
}

Affine translation(Vec3 offset) { return {Affine{}.rows, offset}; }

Affine scaling(Vec3 factors) {
  return {{Vec3{factors.x, 0, 0}, Vec3{0, factors.y, 0}, Vec3{0, 0, factors.z}}, {}};
}

Affine rotation(Vec3 angles) {
  Affine out;
  if (angles.x != 0) out = then(out, about_x(angles.x));
  if (angles.y != 0) out = then(out, about_y(angles.y));
  if (angles.z != 0) out = then(out, about_z(angles.z));
  return out;
}

Affine rotation(Vec3 axis, double angle) {
  if (axis.y == 0 && axis.z == 0) return about_x(axis.x < 0 ? -angle : angle);
  if (axis.x == 0 && axis.z == 0) return about_y(axis.y < 0 ? -angle : angle);
  if (axis.x == 0 && axis.y == 0) return about_z(axis.z < 0 ? -angle : angle);
  // Rodrigues' formula: M = c I + (1 - c) u u^T + s [u]x.
  const Vec3 u = normalize(axis);
  const double s = math::sin_deg(angle), c = math::cos_deg(angle);
  const double v = versine(angle, c);
  return linear({c + v * u.x * u.x, v * u.x * u.y - s * u.z, v * u.x * u.z + s * u.y},
                {v * u.y * u.x + s * u.z, c + v * u.y * u.y, v * u.y * u.z - s * u.x},
                {v * u.z * u.x - s * u.y, v * u.z * u.y + s * u.x, c + v * u.z * u.z});
}

std::optional<Affine> inverse(const Affine& a) {
  if (!is_finite(a)) return std::nullopt;
  const std::optional<Scaled> scaled = scale_rows(a);
  if (!scaled) return std::nullopt;
  const auto& m = scaled->rows;
  const Matrix cofactors = adjugate(m);
  const DoubleDouble det = cofactors[0][0] * m[0].x + cofactors[1][0] * m[0].y + cofactors[2][0] * m[0].z;
  // What is left of products that cancel to their last bits is rounding of the steps before: a singular map.
  if (!(std::fabs(det.hi) > 0x1p-50 * permanent(m))) return std::nullopt;
  Affine out;
  for (std::size_t i = 0; i < 3; ++i) {
    DoubleDouble moved;
    for (std::size_t j = 0; j < 3; ++j) {
      const DoubleDouble entry = cofactors[i][j] / det;
      const int e = -scaled->exponents[j];
      out.rows[i][static_cast<int>(j)] = std::scalbn(entry.hi, e) + 0.0;
      const int axis = static_cast<int>(j);
      moved = moved + entry * two_sum(std::scalbn(a.translation[axis], e), std::scalbn(a.rest[axis], e));
    }
    out.translation[static_cast<int>(i)] = 0.0 - moved.hi;
    out.rest[static_cast<int>(i)] = 0.0 - moved.lo;
  }
  if (!is_finite(out)) return std::nullopt;
  return out;
}

}  // namespace lancer
