#include "tracer/shapes/linear_map.hpp"

namespace lancer::tracer {
namespace {

using Row = std::array<DoubleDouble, 3>;

Row cross2(Vec3 a, Vec3 b) {
  return {two_product(a.y, b.z) - two_product(a.z, b.y), two_product(a.z, b.x) - two_product(a.x, b.z),
          two_product(a.x, b.y) - two_product(a.y, b.x)};
}

/// A matrix whose rows and columns were divided by powers of two, so that the products of its entries neither
/// over- nor underflow.
struct Balanced {
  Rows entries;
  std::array<int, 3> row{}, column{};  // the powers

  explicit Balanced(const Rows& m) : entries(m) {
    for (std::size_t i = 0; i < 3; ++i) {
      row[i] = power_of(m[i]);
      for (int j = 0; j < 3; ++j) entries[i][j] = std::scalbn(m[i][j], -row[i]);
    }
    for (int j = 0; j < 3; ++j) {
      const auto at = static_cast<std::size_t>(j);
      column[at] = power_of({entries[0][j], entries[1][j], entries[2][j]});
      for (Vec3& r : entries) r[j] = std::scalbn(r[j], -column[at]);
    }
  }

 private:
  static int power_of(Vec3 v) { return max_abs(v) > 0 ? std::ilogb(max_abs(v)) : 0; }
};

}  // namespace

Rows accurate_inverse(const Rows& matrix) {
  const Balanced balanced(matrix);
  const Rows& m = balanced.entries;
  const Row columns[3] = {cross2(m[1], m[2]), cross2(m[2], m[0]), cross2(m[0], m[1])};
  const DoubleDouble determinant = columns[0][0] * m[0].x + columns[0][1] * m[0].y + columns[0][2] * m[0].z;
  Rows inverse;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = (columns[j][i] / determinant).hi;
      inverse[i][static_cast<int>(j)] = std::scalbn(entry, -balanced.column[i] - balanced.row[j]);
    }
  }
  return inverse;
}

}  // namespace lancer::tracer
