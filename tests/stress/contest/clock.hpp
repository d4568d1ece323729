#pragma once
// The time, to take differences of.

#include <chrono>

namespace lancer::stress {

inline double now_in_nanoseconds() {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace lancer::stress
