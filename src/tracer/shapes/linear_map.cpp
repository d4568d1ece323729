#include "tracer/shapes/linear_map.hpp"

namespace lancer::tracer {
namespace {

using Row = std::array<DoubleDouble, 3>;

Row cross2(Vec3 a, Vec3 b) {
  return {two_product(a.y, b.z) - two_product(a.z, b.y), two_product(a.z, b.x) - two_product(a.x, b.z),
          two_product(a.x, b.y) - two_product(a.y, b.x)};
}

}  // namespace

Rows accurate_inverse(const Rows& m) {
  const Row columns[3] = {cross2(m[1], m[2]), cross2(m[2], m[0]), cross2(m[0], m[1])};
  const DoubleDouble determinant = columns[0][0] * m[0].x + columns[0][1] * m[0].y + columns[0][2] * m[0].z;
  Rows inverse;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inverse[i][j] = (columns[j][i] / determinant).hi;
  }
  return inverse;
}

}  // namespace lancer::tracer
