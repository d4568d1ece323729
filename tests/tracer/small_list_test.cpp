#include "tracer/small_list.hpp"

#include "catch.hpp"

using lancer::tracer::SmallList;

TEST_CASE("small list: it keeps its order beyond the elements that live in place", "[small_list]") {
  SmallList<int, 2> list;
  for (int i = 0; i < 7; ++i) list.push_back(i);
  REQUIRE(list.size() == 7);
  for (int i = 0; i < 7; ++i) CHECK(list[static_cast<std::size_t>(i)] == i);
  const SmallList<int, 2> copy = list;
  CHECK(copy.back() == 6);
}

TEST_CASE("small list: erasing closes the gap, in place and beyond", "[small_list]") {
  SmallList<int, 3> list;
  for (int i = 0; i < 3; ++i) list.push_back(i);
  list.erase(0);
  CHECK(list[0] == 1);
  CHECK(list.size() == 2);
  for (int i = 3; i < 6; ++i) list.push_back(i);
  list.erase(3);  // 1 2 3 4 5 -> 1 2 3 5
  REQUIRE(list.size() == 4);
  CHECK(list[2] == 3);
  CHECK(list.back() == 5);
  list.push_back(9);
  CHECK(list.size() == 5);
  CHECK(list.back() == 9);
}

TEST_CASE("small list: it may take one of its own elements", "[small_list]") {
  SmallList<int, 1> list;
  list.push_back(7);
  list.push_back(list[0]);
  list.push_back(list[0]);
  CHECK(list[2] == 7);
}
