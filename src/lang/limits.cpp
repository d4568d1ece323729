#include "lang/limits.hpp"

#include <fmt/format.h>
#include <limits>

#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {
constexpr std::uint64_t k_steps_between_looks = 4096;
}

Meter::Meter(const Limits& limits, const std::atomic<bool>* interrupt)
    : limit_(limits.steps == 0 ? std::numeric_limits<std::uint64_t>::max() : limits.steps),
      interrupt_(interrupt) {}

void Meter::check(Span where) {
  if (interrupt_ != nullptr && interrupt_->load(std::memory_order_relaxed)) throw Interrupted{};
  if (used_ > limit_) {
    throw ScriptError(Code::step_limit, where, fmt::format("the script has used up its {} steps", limit_),
                      "if it is meant to run this long, raise the limit with `--max-steps N` (0: none)");
  }
  const std::uint64_t left = limit_ - used_;
  next_check_ = used_ + (left < k_steps_between_looks ? left + 1 : k_steps_between_looks);
}

}  // namespace lancer::lang
