#include "base/number.hpp"

#include <cstdlib>
#include <limits>

#include "catch.hpp"
#include "numbers.hpp"

namespace lancer {

TEST_CASE("number: the fewest digits that read back the same", "[number]") {
  CHECK(to_text(0.1) == "0.1");
  CHECK(to_text(0.1 + 0.2) == "0.30000000000000004");
  CHECK(to_text(1.0 / 3) == "0.3333333333333333");
  CHECK(to_text(100) == "100");
  CHECK(to_text(-1.5) == "-1.5");
  CHECK(to_text(123456.789) == "123456.789");
  CHECK(to_text(9007199254740993.0) == "9007199254740992");
  CHECK(to_text(1.7976931348623157e308) == "1.7976931348623157e+308");
  CHECK(to_text(5e-324) == "5e-324");
}

TEST_CASE("number: exponents from 1e21 on and below 1e-6", "[number]") {
  CHECK(to_text(1e20) == "100000000000000000000");
  CHECK(to_text(123456789012345680000.0) == "123456789012345680000");
  CHECK(to_text(999999999999999900000.0) == "999999999999999900000");
  CHECK(to_text(1e21) == "1e+21");
  CHECK(to_text(1.25e25) == "1.25e+25");
  CHECK(to_text(1e-6) == "0.000001");
  CHECK(to_text(1.25e-6) == "0.00000125");
  CHECK(to_text(9.9e-7) == "9.9e-7");
  CHECK(to_text(1.5e-7) == "1.5e-7");
  CHECK(to_text(-1e-10) == "-1e-10");
}

TEST_CASE("number: never a minus before 0", "[number]") {
  CHECK(to_text(-0.0) == "0");
  CHECK(to_fixed(-0.0, 2) == "0.00");
  CHECK(to_fixed(-0.001, 2) == "0.00");
  CHECK(to_fixed(-0.4, 0) == "0");
  CHECK(to_fixed(-0.006, 2) == "-0.01");
}

TEST_CASE("number: what is not finite has a name", "[number]") {
  CHECK(to_text(std::numeric_limits<double>::infinity()) == "Infinity");
  CHECK(to_text(-std::numeric_limits<double>::infinity()) == "-Infinity");
  CHECK(to_text(std::numeric_limits<double>::quiet_NaN()) == "NaN");
}

TEST_CASE("number: fixed digits round the exact value", "[number]") {
  CHECK(to_fixed(3.14159, 2) == "3.14");
  CHECK(to_fixed(2, 3) == "2.000");
  CHECK(to_fixed(0.125, 2) == "0.12");  // exactly halfway: to even
  CHECK(to_fixed(0.375, 2) == "0.38");
  CHECK(to_fixed(2.5, 0) == "2");
  CHECK(to_fixed(3.5, 0) == "4");
  CHECK(to_fixed(1.005, 2) == "1.00");  // 1.00499999999999989...
  CHECK(to_fixed(0.1, 20) == "0.10000000000000000555");
  CHECK(to_fixed(1e22, 1) == "10000000000000000000000.0");
  CHECK(to_fixed(5e-324, 2) == "0.00");
  const std::string longest = to_fixed(-1.7976931348623157e308, 100);
  CHECK(longest.size() == 1 + 309 + 1 + 100);
  CHECK(longest.substr(0, 18) == "-17976931348623157");
}

TEST_CASE("number: every text reads back as the same number", "[number]") {
  Numbers n(7);
  for (int i = 0; i < 20000; ++i) {
    const double v = i % 2 == 0 ? n.of_any_size(-1074, 1024) : n.of_any_size(-30, 80);
    if (std::strtod(to_text(v).c_str(), nullptr) != v) {
      FAIL_CHECK(to_text(v));
    }
  }
}

}  // namespace lancer
