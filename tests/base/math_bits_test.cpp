// The functions of math.hpp give the same bits on every machine and with every compiler: their results for
// 10,000 arguments are pinned as a hash. Change a hash only together with a function, and knowing that
// pictures change.

#include <bit>
#include <cstdint>

#include "base/math.hpp"
#include "catch.hpp"
#include "numbers.hpp"

namespace lancer {
namespace {

constexpr int k_count = 10000;

/// FNV-1a over the bytes of the results.
class Hash {
 public:
  void add(double value) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (int i = 0; i < 8; ++i, bits >>= 8) hash_ = (hash_ ^ (bits & 0xFF)) * 0x100000001B3;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

template <class F>
std::uint64_t hash_of(F next) {
  Numbers n(2024);
  Hash hash;
  for (int i = 0; i < k_count; ++i) hash.add(next(n, i));
  return hash.value();
}

double angle(Numbers& n, int i) { return i % 2 == 0 ? n.uniform(-360, 360) : n.of_any_size(-30, 30); }
double sine(Numbers& n, int) { return n.uniform(-1, 1); }
double positive(Numbers& n, int i) {
  return i % 2 == 0 ? n.uniform(0.001, 4) : std::fabs(n.of_any_size(-1060, 1020));
}

}  // namespace

TEST_CASE("math: trigonometric bits are the same everywhere", "[math]") {
  CHECK(hash_of([](Numbers& n, int i) { return math::sin_deg(angle(n, i)); }) == 0x3E77CA42D7449CCB);
  CHECK(hash_of([](Numbers& n, int i) { return math::cos_deg(angle(n, i)); }) == 0xACD4751E8B1E5580);
  CHECK(hash_of([](Numbers& n, int i) { return math::tan_deg(angle(n, i)); }) == 0x5571D62037B3A7EE);
  CHECK(hash_of([](Numbers& n, int i) { return math::asin_deg(sine(n, i)); }) == 0x5FA190185F482062);
  CHECK(hash_of([](Numbers& n, int i) { return math::acos_deg(sine(n, i)); }) == 0xD15ED7923AC6EE55);
  CHECK(hash_of([](Numbers& n, int i) { return math::atan_deg(n.of_any_size(i % 40 - 20, 30)); }) ==
        0xF6535B5DE2B179A7);
  CHECK(hash_of([](Numbers& n, int) {
          const double y = n.of_any_size(-20, 20);
          return math::atan2_deg(y, n.of_any_size(-20, 20));
        }) == 0xEE6E1F26F97B58A3);
  CHECK(hash_of([](Numbers& n, int i) { return math::radians(angle(n, i)); }) == 0xDEEE4D7A826676A5);
  CHECK(hash_of([](Numbers& n, int i) { return math::degrees(angle(n, i)); }) == 0x6D7831355B3CF83D);
}

TEST_CASE("math: exponential bits are the same everywhere", "[math]") {
  CHECK(hash_of([](Numbers& n, int i) {
          return math::exp(i % 2 == 0 ? n.uniform(-1, 1) : n.uniform(-745, 709));
        }) == 0x389C778979DA5F56);
  CHECK(hash_of([](Numbers& n, int i) { return math::log(positive(n, i)); }) == 0xBB4CB7BBC33142A0);
  CHECK(hash_of([](Numbers& n, int i) { return math::log2(positive(n, i)); }) == 0xFD6C1A6F2AC898D0);
  CHECK(hash_of([](Numbers& n, int i) { return math::log10(positive(n, i)); }) == 0x96E59BE9E2D45DD0);
  CHECK(hash_of([](Numbers& n, int i) { return math::cbrt(positive(n, i)); }) == 0x223EA872AB3A1CFC);
  CHECK(hash_of([](Numbers& n, int i) {
          const double x = positive(n, i);
          return math::pow(x, n.uniform(-40, 40));
        }) == 0x223537C388D7E266);
  CHECK(hash_of([](Numbers& n, int) { return math::srgb_to_linear(n.uniform(0, 1)); }) == 0xE3923EA1DBCE2A9E);
  CHECK(hash_of([](Numbers& n, int) { return math::linear_to_srgb(n.uniform(0, 1)); }) == 0xAFEC269E2DD74B75);
}

}  // namespace lancer
