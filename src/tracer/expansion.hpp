#pragma once
// Exact sums and products of doubles as sums of doubles, which is quick where few of them are needed. After
// J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997).

#include <algorithm>
#include <array>
#include <cmath>

#include "base/double_double.hpp"
#include "base/vec.hpp"

namespace lancer::tracer {

/// A sum of doubles that share no bits, the least first, none of them 0. Exact where no term of what is
/// worked out over- or underflows (see is_expandable). Its room is that of the sum of three determinants of
/// two differences of vectors and one vector.
class Expansion {
 public:
  Expansion() = default;
  Expansion(double value) { push(value); }  // NOLINT: a double is one of these
  Expansion(const Expansion& other) { *this = other; }
  Expansion& operator=(const Expansion& other) {
    count_ = other.count_;
    std::copy_n(other.part_.begin(), count_, part_.begin());
    return *this;
  }

  int sign() const { return count_ == 0 ? 0 : part_[count_ - 1] > 0 ? 1 : -1; }

  /// Off by 2^-104 of it at most.
  DoubleDouble rounded() const {
    DoubleDouble sum;
    for (std::size_t i = 0; i < count_; ++i) {
      const DoubleDouble next = quick_two_sum(part_[i], sum.hi);
      sum = quick_two_sum(next.hi, next.lo + sum.lo);
    }
    return sum;
  }

  friend Expansion operator+(const Expansion& a, const Expansion& b) { return sum(a, b, 1); }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return sum(a, b, -1); }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    if (a.count_ < b.count_) return b * a;
    if (b.count_ == 0) return b;
    Expansion out = a.scaled(b.part_[0]);
    for (std::size_t i = 1; i < b.count_; ++i) out = out + a.scaled(b.part_[i]);
    return out;
  }

 private:
  /// a + sign b: Shewchuk's fast expansion sum.
  static Expansion sum(const Expansion& a, const Expansion& b, double sign) {
    Expansion out;
    if (a.count_ == 1 && b.count_ == 1) {  // Most of them where coordinates are short.
      const DoubleDouble all = two_sum(a.part_[0], sign * b.part_[0]);
      out.push(all.lo);
      out.push(all.hi);
      return out;
    }
    double sum = 0;
    for (std::size_t i = 0, j = 0; i < a.count_ || j < b.count_;) {
      const bool from_a = j == b.count_ || (i < a.count_ && std::fabs(a.part_[i]) < std::fabs(b.part_[j]));
      const DoubleDouble next = two_sum(sum, from_a ? a.part_[i++] : sign * b.part_[j++]);
      out.push(next.lo);
      sum = next.hi;
    }
    out.push(sum);
    return out;
  }
  /// Shewchuk's expansion scaling.
  Expansion scaled(double by) const {
    Expansion out;
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const DoubleDouble product = two_product(part_[i], by);
      const DoubleDouble low = two_sum(sum, product.lo);
      const DoubleDouble high = quick_two_sum(product.hi, low.hi);
      out.push(low.lo);
      out.push(high.lo);
      sum = high.hi;
    }
    out.push(sum);
    return out;
  }
  void push(double value) {
    if (value != 0) part_[count_++] = value;
  }

  std::array<double, 288> part_;  // NOLINT: what is not in use is not read
  std::size_t count_ = 0;
};

/// May the components be terms of determinants? Then these, and their quotients, are doubles to the last bit.
inline bool is_expandable(Vec3 v) {
  const auto fits = [](double x) {
    const double size = std::fabs(x);
    return size == 0 || (size >= 0x1p-130 && size <= 0x1p130);
  };
  return fits(v.x) && fits(v.y) && fits(v.z);
}

}  // namespace lancer::tracer
