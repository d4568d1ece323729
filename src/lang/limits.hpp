#pragma once
// What a script may use up, and the meter that counts it.

#include <atomic>
#include <cstdint>

#include "base/source.hpp"

namespace lancer::lang {

/// 0 means no limit.
struct Limits {
  std::uint64_t steps = 100'000'000;
  std::uint64_t objects = 10'000'000;
  std::uint32_t calls = 10'000;
};

/// Counts steps: a statement, a call, an iteration, or an element or 64 characters produced, copied or
/// compared. Looks at `interrupt` now and then.
class Meter {
 public:
  Meter(const Limits& limits, const std::atomic<bool>* interrupt);

  /// Throws ScriptError(step_limit) at `where`, or Interrupted.
  void charge(std::uint64_t steps, Span where) {
    used_ += steps;
    if (used_ >= next_check_) check(where);
  }
  std::uint64_t used() const { return used_; }

 private:
  void check(Span where);

  std::uint64_t limit_;
  std::uint64_t used_ = 0;
  std::uint64_t next_check_ = 0;
  const std::atomic<bool>* interrupt_;
};

}  // namespace lancer::lang
