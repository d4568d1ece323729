#pragma once
// Several things done at once, as far as there are threads for it.

#include <cstddef>
#include <functional>

namespace lancer::tracer {

/// Calls work(0) .. work(count - 1), and returns when all are done. What was written before is seen by all of
/// them, and what they write is seen after.
void at_once(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace lancer::tracer
