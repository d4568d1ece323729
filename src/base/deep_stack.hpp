#pragma once
// Recursion as deep as a script may ask for: calls nest 10,000 deep, expressions 1,000, which is more than
// the stack that a thread gets by default holds.

#include <cstddef>
#include <functional>

namespace lancer {

/// Runs `work` to its end on a thread of its own with a large stack, and passes its exception on. Falls back
/// to smaller stacks where memory is limited. Called within `work` again, it simply runs the new work in
/// place.
void on_deep_stack(const std::function<void()>& work);

/// Bytes of stack that are left below the caller on a deep stack (less a reserve); elsewhere a cautious
/// estimate of the calling thread's own.
std::size_t stack_left();

}  // namespace lancer
