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

TEST_CASE("small list: copied and moved, short and long", "[small_list]") {
  for (const int count : {0, 1, 2, 3, 9}) {
    CAPTURE(count);
    SmallList<int, 2> list;
    for (int i = 0; i < count; ++i) list.push_back(i);
    const auto is_whole = [&](const SmallList<int, 2>& l) {
      for (int i = 0; i < count; ++i) {
        if (l[static_cast<std::size_t>(i)] != i) return false;
      }
      return l.size() == static_cast<std::size_t>(count);
    };
    for (const int before : {0, 1, 5}) {
      SmallList<int, 2> other;
      for (int i = 0; i < before; ++i) other.push_back(-1);
      other = list;
      CHECK(is_whole(other));
      SmallList<int, 2> taken;
      for (int i = 0; i < before; ++i) taken.push_back(-1);
      taken = std::move(other);
      CHECK(is_whole(taken));
      other.clear();
      other.push_back(7);  // what was moved from can be used again
      CHECK(other[0] == 7);
    }
    const SmallList<int, 2> copy(list);
    CHECK(is_whole(copy));
    list.push_back(5);
    CHECK(is_whole(copy));
  }
}
