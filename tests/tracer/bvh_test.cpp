#include "tracer/bvh.hpp"

#include <algorithm>

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

std::vector<Aabb> random_boxes(std::size_t count, double size) {
  Random random(count);
  std::vector<Aabb> boxes(count);
  for (Aabb& box : boxes) {
    box.add(random.in_cube(10));
    box.add(box.lo + Vec3{random(), random(), random()} * size);
  }
  return boxes;
}

}  // namespace

TEST_CASE("bvh: what a ray may meet is visited, at any limit", "[bvh]") {
  const std::vector<Aabb> boxes = random_boxes(700, 1.5);
  const Bvh tree(boxes);
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 origin = random.in_cube(15);
    const Probe probe(origin, random.direction());
    const double limit = i % 2 == 0 ? std::numeric_limits<double>::infinity() : random() * 20;
    std::vector<bool> visited(boxes.size());
    std::uint64_t visits = 0;
    tree.traverse(probe, limit, visits, [&](std::uint32_t item) {
      visited[item] = true;
      return false;
    });
    for (std::size_t item = 0; item < boxes.size(); ++item) {
      const Interval part = interval(boxes[item], probe);
      if (part.enter <= part.leave && part.enter <= limit) REQUIRE(visited[item]);
    }
    CHECK(visits < 2 * boxes.size());
  }
}

TEST_CASE("bvh: a tree visits far fewer items than there are", "[bvh]") {
  const std::vector<Aabb> boxes = random_boxes(4000, 0.1);
  const Bvh tree(boxes);
  std::uint64_t visits = 0, items = 0;
  tree.traverse(Probe({-20, 0.1, 0.2}, normalize({1, 0.01, 0.02})), std::numeric_limits<double>::infinity(),
                visits, [&](std::uint32_t) {
                  ++items;
                  return false;
                });
  CHECK(items < 200);
}

TEST_CASE("bvh: equal boxes and boxes in a geometric row end at a bounded depth", "[bvh]") {
  std::vector<Aabb> boxes(5000);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double at = i < 2000 ? 0 : std::ldexp(1.0, static_cast<int>(i % 1000));
    boxes[i].add(Vec3{at, at, at});
    boxes[i].add(Vec3{at + 1, at, at});
  }
  const Bvh tree(boxes);
  std::vector<std::pair<std::uint32_t, int>> stack{{0, 0}};
  std::size_t found = 0;
  while (!stack.empty()) {
    const auto [at, depth] = stack.back();
    stack.pop_back();
    REQUIRE(depth < Bvh::k_max_depth);
    const Bvh::Node& node = tree.nodes()[at];
    found += node.count;
    if (node.count > 0) continue;
    stack.push_back({at + 1, depth + 1});
    stack.push_back({node.first, depth + 1});
  }
  CHECK(found == boxes.size());
}

TEST_CASE("bvh: an empty one is never met", "[bvh]") {
  std::uint64_t visits = 0;
  CHECK_FALSE(
      Bvh(std::vector<Aabb>{}).traverse(Probe({}, {1, 0, 0}), 1, visits, [](std::uint32_t) { return true; }));
}

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
  CHECK(Bvh(random_boxes(1000, 1), &cancel).nodes().size() == 1);
}
