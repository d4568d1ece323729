#include "base/deep_stack.hpp"

#include <stdexcept>
#include <string>
#include <thread>

#include "catch.hpp"

namespace lancer {
namespace {

/// Recursion that needs about `frame` bytes a call and cannot be turned into a loop.
int recurse(int depth) {
  constexpr std::size_t k_frame = 16 * 1024;
  volatile char page[k_frame];
  page[0] = static_cast<char>(depth);
  page[k_frame - 1] = static_cast<char>(depth);
  if (depth == 0) return page[0];
  const int below = recurse(depth - 1);
  return below + (page[k_frame - 1] == static_cast<char>(depth) ? 1 : 0);
}

/// How deep it goes until the stack is said to end.
int until_the_end(int depth) {
  volatile char page[16 * 1024];
  page[0] = 1;
  if (stack_left() < 64 * 1024) return depth;
  return until_the_end(depth + 1) + page[0] - 1;
}

}  // namespace

TEST_CASE("deep stack: recursion of hundreds of megabytes", "[deep_stack]") {
  int reached = 0;
  std::size_t left = 0;
  on_deep_stack([&] {
    left = stack_left();
    // As far as what the machine gave us carries: 20,000 calls of 16 KB are 320 MB.
    const int depth = left > (std::size_t{600} << 20) ? 20000 : 500;
    reached = recurse(depth) == depth ? depth : -1;
  });
  CHECK(left > std::size_t{48} << 20);
  CHECK(reached >= 500);
}

TEST_CASE("deep stack: the stack says when it ends", "[deep_stack]") {
  int depth = 0;
  std::thread small([&] { depth = until_the_end(0); });
  small.join();
  CHECK(depth > 4);
  CHECK(until_the_end(0) > 4);
}

TEST_CASE("deep stack: exceptions come back", "[deep_stack]") {
  std::string caught;
  try {
    on_deep_stack([] { throw std::runtime_error("from below"); });
  } catch (const std::runtime_error& e) {
    caught = e.what();
  }
  CHECK(caught == "from below");
}

TEST_CASE("deep stack: work within work stays on its thread", "[deep_stack]") {
  std::thread::id outer, inner;
  on_deep_stack([&] {
    outer = std::this_thread::get_id();
    on_deep_stack([&] { inner = std::this_thread::get_id(); });
  });
  CHECK(outer == inner);
  CHECK(outer != std::this_thread::get_id());
}

TEST_CASE("deep stack: one thread after the other", "[deep_stack]") {
  int count = 0;
  for (int i = 0; i < 50; ++i) on_deep_stack([&] { ++count; });
  CHECK(count == 50);
}

}  // namespace lancer
