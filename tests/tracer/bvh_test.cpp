#include "tracer/bvh.hpp"

#include <algorithm>
#include <cstring>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

constexpr double k_no_limit = std::numeric_limits<double>::infinity();

Bvh tree_over(const std::vector<Aabb>& boxes, const std::atomic<bool>* cancel = nullptr) {
  return Bvh(
      static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t item) { return boxes[item]; }, cancel);
}

Aabb box_between(Vec3 a, Vec3 b) {
  Aabb box;
  box.add(a);
  box.add(b);
  return box;
}

/// One in four has no extent along an axis.
std::vector<Aabb> random_boxes(std::size_t count, double size) {
  Random random(count);
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at = random.in_cube(10);
    Vec3 extent = Vec3{random(), random(), random()} * size;
    if (i % 4 == 0) extent[static_cast<int>(i / 4 % 3)] = 0;
    boxes.push_back(box_between(at, at + extent));
  }
  return boxes;
}

std::vector<Aabb> moved(std::vector<Aabb> boxes, double scale, Vec3 by) {
  for (Aabb& box : boxes) box = {box.lo * scale + by, box.hi * scale + by};
  return boxes;
}

/// Clusters, each far smaller than the space between them, one within the other.
std::vector<Aabb> nested_clusters(int levels, double ratio) {
  std::vector<Aabb> boxes;
  double scale = 1;
  for (int level = 0; level < levels; ++level, scale *= ratio) {
    const std::vector<Aabb> cluster = moved(random_boxes(40, 2), scale, Vec3{3, -2, 1} * scale);
    boxes.insert(boxes.end(), cluster.begin(), cluster.end());
  }
  return boxes;
}

Vec3 point_of(const Aabb& box, Random& random) {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    const double share = random();
    // As often a corner or an edge as the inside.
    p[axis] = share < 0.3   ? box.lo[axis]
              : share > 0.7 ? box.hi[axis]
                            : box.lo[axis] + (box.hi[axis] - box.lo[axis]) * share;
  }
  return p;
}

/// From anywhere, or from a box's side, towards a box's corner, edge or inside, or along an axis.
Probe random_probe(const std::vector<Aabb>& boxes, double distance, Random& random) {
  const auto any_box = [&] {
    return boxes[static_cast<std::size_t>(random() * static_cast<double>(boxes.size()))];
  };
  const Vec3 target = point_of(any_box(), random);
  const Aabb near = any_box();
  const double size = max_abs(near.hi - near.lo);
  switch (static_cast<int>(random() * 4)) {
    case 0: {
      Vec3 d{random() < 0.5 ? 0.0 : -0.0, random() < 0.5 ? 0.0 : -0.0, random() < 0.5 ? 0.0 : -0.0};
      d[static_cast<int>(random() * 3)] = random() < 0.5 ? 1 : -1;
      return Probe(target - d * distance, d);
    }
    case 1: {
      const Vec3 from = point_of(near, random);
      const Vec3 way = target - from;
      return Probe(from, max_abs(way) > 0 ? normalize(way) : Vec3{0, 0, 1});
    }
    case 2: {
      // All but along an axis.
      Vec3 d{random() * 1e-19, random() * 1e-13, 0};
      d = random() < 0.5 ? normalize(Vec3{d.x, 1, d.y}) : normalize(Vec3{-1, d.y, d.x});
      return Probe(target - d * distance, d);
    }
    default: {
      const Vec3 d = random.direction();
      return Probe(target - d * distance + random.in_cube(0.1) * size, d);
    }
  }
}

struct Visited {
  std::vector<std::uint32_t> items;
  std::uint64_t nodes = 0;
};

Visited visit(const Bvh& tree, const Probe& probe, double limit, Order order = Order::nearest_first) {
  Visited out;
  tree.traverse(
      probe, limit, out.nodes,
      [&](std::uint32_t item) {
        out.items.push_back(item);
        return false;
      },
      order);
  return out;
}

/// How many boxes the rays meet; every one of them must be visited, and none twice.
std::size_t check_visits(const std::vector<Aabb>& boxes, double distance, int rays) {
  const Bvh tree = tree_over(boxes);
  Random random(boxes.size() + 1);
  std::size_t met = 0;
  for (int i = 0; i < rays; ++i) {
    const Probe probe = random_probe(boxes, distance * random(), random);
    const double limit = i % 2 == 0 ? k_no_limit : distance * random() * 2;
    std::vector<int> visits(boxes.size());
    const Order order = i % 3 == 0 ? Order::any : Order::nearest_first;
    for (const std::uint32_t item : visit(tree, probe, limit, order).items) ++visits[item];
    for (std::size_t item = 0; item < boxes.size(); ++item) {
      const Interval part = interval(boxes[item], probe);
      const bool meets = part.enter <= part.leave && part.enter <= limit;
      REQUIRE(visits[item] <= 1);
      if (!meets) continue;
      ++met;
      REQUIRE(visits[item] == 1);
    }
  }
  return met;
}

}  // namespace

TEST_CASE("bvh: what a ray may meet is visited, at any limit", "[bvh]") {
  for (const std::size_t count : {1U, 2U, 3U, 7U, 8U, 9U, 40U, 700U}) {
    CHECK(check_visits(random_boxes(count, 1.5), 15, 400) > 200);
    CHECK(check_visits(random_boxes(count, 1.5), 110, 400) > 200);
  }
}

TEST_CASE("bvh: a ray that all but passes by the corner of a box is not kept from it", "[bvh]") {
  // The unit of the frame is 4, so that the largest roundings happen 16 away: beyond that the ray is moved
  // up.
  const std::vector<Aabb> boxes{box_between({-1, -1, -1}, {1, 1, 1})};
  const Bvh tree = tree_over(boxes);
  Random random(6);
  int met = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 corner{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
    const Vec3 d = random.direction();
    const Probe probe(corner * (1 - 1e-10) - d * (i % 2 == 0 ? 15 : 17), d);
    const Interval part = interval(boxes[0], probe);
    // Of those that go on through the box, too many are far from any rounding.
    if (!(part.enter <= part.leave) || part.leave - part.enter > 1e-6) continue;
    ++met;
    REQUIRE(visit(tree, probe, part.enter).items.size() == 1);
  }
  CHECK(met > 30000);
}

TEST_CASE("bvh: nothing is lost in scenes of any size and anywhere", "[bvh]") {
  const std::vector<Aabb> boxes = random_boxes(300, 1);
  for (const double scale : {1e-290, 1e-90, 1e-30, 1e-3, 1e6, 1e40, 1e90, 1e290}) {
    CHECK(check_visits(moved(boxes, scale, {}), 20 * scale, 200) > 100);
    CHECK(check_visits(moved(boxes, scale, Vec3{1, -3, 2} * (1e9 * scale)), 20 * scale, 200) > 100);
    CHECK(check_visits(moved(boxes, scale, Vec3{1, -3, 2} * (1e15 * scale)), 20 * scale, 200) > 100);
  }
}

TEST_CASE("bvh: nothing is lost by rays that come from far away", "[bvh]") {
  const std::vector<Aabb> boxes = random_boxes(300, 1);
  for (const double distance : {1e2, 1e5, 1e8, 1e12, 1e16, 1e50, 1e200, 1e300}) {
    CHECK(check_visits(boxes, distance, 200) > 20);
    CHECK(check_visits(moved(boxes, 1e-100, {1, 2, 3}), distance, 50) > 20);
  }
}

TEST_CASE("bvh: nothing is lost where sizes differ beyond what floats hold", "[bvh]") {
  for (const double ratio : {1e-2, 1e-5, 1e-9, 1e-30}) {
    const std::vector<Aabb> boxes = nested_clusters(9, ratio);
    for (double distance = 30; distance > 1e-20; distance *= 1e-4) check_visits(boxes, distance, 60);
  }
}

TEST_CASE("bvh: boxes without bounds or numbers do no harm", "[bvh]") {
  std::vector<Aabb> boxes = random_boxes(60, 1);
  constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
  boxes[3] = {{-k_no_limit, 0, 0}, {k_no_limit, 1, 1}};
  boxes[17] = {{-k_no_limit, -k_no_limit, -k_no_limit}, {k_no_limit, k_no_limit, k_no_limit}};
  boxes[31] = {{k_nan, 0, 0}, {1, 1, k_nan}};
  boxes[40] = {{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}};
  boxes[41] = Aabb{};
  const Bvh tree = tree_over(boxes);
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Probe probe(random.in_cube(15), random.direction());
    std::vector<std::uint32_t> items = visit(tree, probe, k_no_limit).items;
    std::sort(items.begin(), items.end());
    for (std::uint32_t item = 0; item < boxes.size(); ++item) {
      const Interval part = interval(boxes[item], probe);
      if (part.enter <= part.leave) REQUIRE(std::binary_search(items.begin(), items.end(), item));
    }
  }
}

TEST_CASE("bvh: a tree visits far fewer items than there are", "[bvh]") {
  const std::vector<Aabb> plain = random_boxes(4000, 0.1);
  const Vec3 origin{-20, 0.1, 0.2};
  const std::size_t usual =
      visit(tree_over(plain), Probe(origin, normalize({1, 0.01, 0.02})), k_no_limit).items.size();
  CHECK(usual < 200);
  // Nor does it take more where the scene is tiny, huge or far away, or the ray comes from afar.
  for (const double scale : {1e-90, 1e90}) {
    const Vec3 by = Vec3{1, 1, 1} * (1e5 * scale);
    const Bvh tree = tree_over(moved(plain, scale, by));
    CHECK(visit(tree, Probe(origin * scale + by, normalize({1, 0.01, 0.02})), k_no_limit).items.size() <=
          usual + 4);
  }
  const Vec3 direction = normalize({1, 0.01, 0.02});
  const Bvh tree = tree_over(plain);
  CHECK(visit(tree, Probe(origin - direction * 1e6, direction), k_no_limit).items.size() <= usual + 4);
}

TEST_CASE("bvh: a small part of a large scene is as well sorted as if it were alone", "[bvh]") {
  // With one frame for all, what is 2e-9 of the whole would be one point.
  std::vector<Aabb> boxes = random_boxes(1000, 0.2);
  boxes.push_back(box_between({-1e10, -1e10, -1e10}, {1e10, 1e10, 1e10}));
  const Bvh tree = tree_over(boxes);
  CHECK(tree.frames().size() > 1);
  CHECK(visit(tree, Probe({-20, 0.1, 0.2}, normalize({1, 0.01, 0.02})), k_no_limit).items.size() < 100);
}

TEST_CASE("bvh: equal boxes and boxes in a geometric row end at a bounded depth", "[bvh]") {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 5000; ++i) {
    const double at = i < 2000 ? 0 : std::ldexp(1.0, i % 1000);
    boxes.push_back(box_between({at, at, at}, {at + 1, at, at}));
  }
  const Bvh tree = tree_over(boxes);
  struct Place {
    Child child;
    std::size_t depth;
  };
  std::vector<Place> stack{{Child::node(tree.frames()[0].root), 1}};
  std::vector<int> found(boxes.size());
  while (!stack.empty()) {
    const auto [child, depth] = stack.back();
    stack.pop_back();
    REQUIRE(depth <= k_max_depth);
    if (child.is_none()) continue;
    if (child.is_leaf()) {
      std::size_t i = child.index();
      do ++found[tree.items()[i] & ~k_last_item];
      while ((tree.items()[i++] & k_last_item) == 0);
    } else if (child.is_node()) {
      for (const Child below : tree.nodes()[child.index()].children) stack.push_back({below, depth + 1});
    } else {
      stack.push_back({Child::node(tree.frames()[child.index()].root), 1});
    }
  }
  CHECK(std::count(found.begin(), found.end(), 1) == static_cast<std::ptrdiff_t>(boxes.size()));
  CHECK(check_visits(boxes, 10, 20) > 100);
}

TEST_CASE("bvh: an empty one is never met", "[bvh]") {
  std::uint64_t visits = 0;
  CHECK_FALSE(tree_over({}).traverse(Probe({}, {1, 0, 0}), 1, visits, [](std::uint32_t) { return true; }));
  tree_over({}).around({}, [](std::uint32_t) { FAIL(); });
}

TEST_CASE("bvh: a visitor ends the search, and what it lowers the limit to counts at once", "[bvh]") {
  const std::vector<Aabb> boxes = random_boxes(2000, 4);
  const Bvh tree = tree_over(boxes);
  const Probe probe({-20, 0.1, 0.2}, normalize({1, 0.01, 0.02}));
  std::uint64_t visits = 0;
  int calls = 0;
  CHECK(tree.traverse(probe, k_no_limit, visits, [&](std::uint32_t) { return ++calls == 3; }));
  CHECK(calls == 3);
  double limit = k_no_limit;
  Visited few;
  tree.traverse(probe, limit, few.nodes, [&](std::uint32_t item) {
    const Interval part = interval(boxes[item], probe);
    if (part.enter <= part.leave) limit = std::min(limit, part.leave);
    few.items.push_back(item);
    return false;
  });
  CHECK(few.items.size() * 2 < visit(tree, probe, k_no_limit).items.size());
}

TEST_CASE("bvh: what is around a point is visited", "[bvh]") {
  for (std::vector<Aabb> boxes : {random_boxes(500, 4), nested_clusters(6, 1e-6)}) {
    const Bvh tree = tree_over(boxes);
    Random random(3);
    std::size_t total = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = point_of(boxes[static_cast<std::size_t>(i) % boxes.size()], random);
      std::vector<int> visits(boxes.size());
      tree.around(p, [&](std::uint32_t item) { ++visits[item]; });
      for (std::size_t item = 0; item < boxes.size(); ++item) {
        REQUIRE(visits[item] <= 1);
        if (boxes[item].contains(p)) REQUIRE(visits[item] == 1);
        total += static_cast<std::size_t>(visits[item]);
      }
    }
    CHECK(total < 300 * boxes.size() / 4);
  }
}

TEST_CASE("bvh: the tree does not depend on the number of threads", "[bvh]") {
  std::vector<Aabb> boxes = random_boxes(150000, 0.1);
  const std::vector<Aabb> small = moved(random_boxes(20000, 0.5), 1e-9, {1, 1, 1});
  boxes.insert(boxes.end(), small.begin(), small.end());
  const tbb::global_control enough(tbb::global_control::max_allowed_parallelism, 5);
  const Bvh one = tbb::task_arena(1).execute([&] { return tree_over(boxes); });
  CHECK(one.frames().size() > 1);
  for (const int threads : {2, 5}) {
    const Bvh other = tbb::task_arena(threads).execute([&] { return tree_over(boxes); });
    REQUIRE(other.nodes().size() == one.nodes().size());
    CHECK(std::memcmp(other.nodes().data(), one.nodes().data(), one.nodes().size_bytes()) == 0);
    CHECK(other.items() == one.items());
    REQUIRE(other.frames().size() == one.frames().size());
    for (std::size_t i = 0; i < one.frames().size(); ++i) {
      CHECK(other.frames()[i].root == one.frames()[i].root);
      CHECK(other.frames()[i].origin == one.frames()[i].origin);
    }
  }
}

#if defined(LANCER_HAS_AVX2)
TEST_CASE("bvh: with and without AVX2 the same is visited in the same order", "[bvh]") {
  if (!k_use_avx2) return;
  const std::vector<Aabb> boxes = random_boxes(3000, 1);
  const Bvh tree = tree_over(boxes);
  Random random(8);
  for (int i = 0; i < 400; ++i) {
    const Probe probe = random_probe(boxes, 20, random);
    const double limit = i % 2 == 0 ? k_no_limit : 10;
    std::array<Visited, 4> found;
    const auto add = [](void* to, const std::uint32_t* item) {
      do static_cast<Visited*>(to)->items.push_back(*item & ~k_last_item);
      while ((*item++ & k_last_item) == 0);
      return false;
    };
    const auto walk_with = [&](bool (*walk)(const Walk&), Visited& out) {
      walk({tree.nodes().data(), tree.frames().data(), tree.items().data(), probe, limit, out.nodes, &out,
            add});
    };
    walk_with(baseline::walk_nearest_first, found[0]);
    walk_with(avx2::walk_nearest_first, found[1]);
    walk_with(baseline::walk_in_any_order, found[2]);
    walk_with(avx2::walk_in_any_order, found[3]);
    REQUIRE(found[0].items == found[1].items);
    REQUIRE(found[0].nodes == found[1].nodes);
    REQUIRE(found[2].items == found[3].items);
    REQUIRE(found[2].nodes == found[3].nodes);
  }
}
#endif

TEST_CASE("bvh: a ray in the plane of a box's side may be in the box", "[bvh]") {
  Aabb box;
  box.add(Vec3{-1, -1, -1});
  box.add(Vec3{1, 1, 1});
  for (const double x : {-1.0, 1.0}) {
    for (const double zero : {0.0, -0.0}) {
      const Interval part = interval(box, Probe({x, 0.5, 5}, {zero, zero, -1}));
      CHECK(part.enter <= 4);
      CHECK(part.leave >= 6);
    }
  }
  const Interval beside = interval(box, Probe({1.5, 0, 5}, {0, 0, -1}));
  CHECK(beside.enter > beside.leave);
}

TEST_CASE("bvh: cancelling ends the build", "[bvh]") {
  const std::atomic<bool> cancel{true};
  CHECK(tree_over(random_boxes(1000, 1), &cancel).nodes().size() == 1);
}
