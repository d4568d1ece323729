#include "base/source.hpp"

#include "catch.hpp"

namespace lancer {

TEST_CASE("source: lines and columns from 1", "[source]") {
  const Source s("a.scn", "one\ntwo\n\nfour");
  CHECK(s.position(0) == Position{1, 1});
  CHECK(s.position(3) == Position{1, 4});  // the line end belongs to its line
  CHECK(s.position(4) == Position{2, 1});
  CHECK(s.position(8) == Position{3, 1});
  CHECK(s.position(11) == Position{4, 3});
  CHECK(s.position(13) == Position{4, 5});
  CHECK(s.position(1000) == Position{4, 5});
  CHECK(s.line(1) == "one");
  CHECK(s.line(3).empty());
  CHECK(s.line(4) == "four");
  CHECK(s.line_start(2) == 4);
}

TEST_CASE("source: columns count code points, a tab is one", "[source]") {
  // a, tab, e acute (2 bytes), euro (3), an emoji (4), b
  const Source s("a.scn",
                 "a\t\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"
                 "b");
  CHECK(s.position(2) == Position{1, 3});
  CHECK(s.position(4) == Position{1, 4});
  CHECK(s.position(7) == Position{1, 5});
  CHECK(s.position(11) == Position{1, 6});
}

TEST_CASE("source: carriage returns before line ends are no part of a line", "[source]") {
  const Source s("a.scn", "one\r\ntwo\r\n");
  CHECK(s.line(1) == "one");
  CHECK(s.line(2) == "two");
  CHECK(s.line(3).empty());
  CHECK(s.position(5) == Position{2, 1});
}

TEST_CASE("source: a byte order mark takes no column", "[source]") {
  const Source s("a.scn", "\xEF\xBB\xBFlet a = 1\nlet b = 2");
  CHECK(s.position(3) == Position{1, 1});
  CHECK(s.position(7) == Position{1, 5});
  CHECK(s.position(17) == Position{2, 5});
}

TEST_CASE("source: an empty text has one empty line", "[source]") {
  const Source s("a.scn", "");
  CHECK(s.position(0) == Position{1, 1});
  CHECK(s.line(1).empty());
}

TEST_CASE("source: a map keeps its sources in place", "[source]") {
  SourceMap map;
  const auto first = map.add("a.scn", "let a = 1");
  const Source* kept = &map[first];
  for (int i = 0; i < 100; ++i) map.add("more.scn", "x");
  CHECK(&map[first] == kept);
  CHECK(map.size() == 101);
  CHECK(map.text({first, 4, 5}) == "a");
  CHECK(join({0, 1, 3}, {0, 7, 9}) == Span{0, 1, 9});
}

}  // namespace lancer
