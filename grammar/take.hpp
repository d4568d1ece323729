#pragma once
// Moving the finished parts of a rule from their stack to the arena. Internal to builder*.cpp.

#include <span>
#include <vector>

#include "lang/ast.hpp"

namespace lancer::grammar {

/// Moves the entries from the first that begins at or behind `begin` into the arena.
template <class T, class BeginOf>
std::span<T> take(ast::Arena& arena, std::vector<T>& stack, std::uint32_t begin, BeginOf begin_of) {
  auto first = stack.end();
  while (first != stack.begin() && begin_of(*(first - 1)) >= begin) --first;
  const auto count = static_cast<std::size_t>(stack.end() - first);
  const std::span<T> out = arena.copy(stack.data() + (first - stack.begin()), count);
  stack.erase(first, stack.end());
  return out;
}

}  // namespace lancer::grammar
