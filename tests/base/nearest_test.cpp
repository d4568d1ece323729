#include "base/diagnostic.hpp"
#include "catch.hpp"

namespace lancer {

TEST_CASE("nearest: a slip of a letter finds its word", "[nearest]") {
  const std::vector<std::string_view> words{"sphere", "plane", "radius", "center", "specular", "eye", "up"};
  CHECK(nearest("spere", words) == "sphere");       // left out
  CHECK(nearest("sphhere", words) == "sphere");     // doubled
  CHECK(nearest("sphera", words) == "sphere");      // replaced
  CHECK(nearest("raduis", words) == "radius");      // swapped
  CHECK(nearest("spceualr", words) == "specular");  // two swaps in eight letters
  CHECK(nearest("ey", words) == "eye");
}

TEST_CASE("nearest: what differs in case alone is near", "[nearest]") {
  CHECK(nearest("RADIUS", {"radius", "RADIUM"}) == "radius");
  CHECK(nearest("Spere", {"sphere"}) == "sphere");
  CHECK(nearest("K", {"k"}) == "k");
}

TEST_CASE("nearest: what is too far stays unnamed", "[nearest]") {
  CHECK(nearest("cylinder", {"sphere", "center"}).empty());
  CHECK(nearest("a", {"b", "c"}).empty());
  CHECK(nearest("cat", {"dog"}).empty());
  CHECK(nearest("planet", {"p"}).empty());
  CHECK(nearest("x", {}).empty());
  CHECK(nearest("", {"abc"}).empty());
}

TEST_CASE("nearest: the nearer of two, and the first of equals", "[nearest]") {
  CHECK(nearest("lenght", {"light", "length"}) == "length");
  CHECK(nearest("cone", {"cane", "cube", "come"}) == "cane");
}

}  // namespace lancer
