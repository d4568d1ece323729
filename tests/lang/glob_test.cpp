#include "lang/glob.hpp"

#include <string>

#include "catch.hpp"

using lancer::lang::is_glob;
using lancer::lang::matches_glob;

TEST_CASE("glob: a star stands for any characters, a question mark for one", "[glob]") {
  CHECK(matches_glob("bead *", "bead 12"));
  CHECK(matches_glob("bead *", "bead "));
  CHECK_FALSE(matches_glob("bead *", "Bead 1"));
  CHECK_FALSE(matches_glob("bead *", "a bead 1"));
  CHECK(matches_glob("*a*b*", "xxaxxbxx"));
  CHECK_FALSE(matches_glob("*a*b", "abx"));
  CHECK(matches_glob("a?c", "abc"));
  CHECK_FALSE(matches_glob("a?c", "ac"));
  CHECK(matches_glob("", ""));
  CHECK(matches_glob("**", ""));
  CHECK_FALSE(matches_glob("?", ""));
}

TEST_CASE("glob: a character is a code point", "[glob]") {
  CHECK(matches_glob("?", "\xC3\xA9"));
  CHECK_FALSE(matches_glob("??", "\xC3\xA9"));
  CHECK(matches_glob("*\xC3\xA9?", "caf\xC3\xA9s"));
}

TEST_CASE("glob: many stars against a long name take no time", "[glob]") {
  std::string pattern;
  for (int i = 0; i < 200; ++i) pattern += "*a";
  CHECK_FALSE(matches_glob(pattern + "b", std::string(20'000, 'a')));
}

TEST_CASE("glob: what stands for other names", "[glob]") {
  CHECK(is_glob("a*"));
  CHECK(is_glob("?"));
  CHECK_FALSE(is_glob("bead [1]"));
}
