#include "tracer/packet/waves.hpp"

#include <utility>

namespace lancer::tracer {

Rays& Waves::room(int level, bool transmitted) {
  const std::size_t kind = 2 * static_cast<std::size_t>(level) + (transmitted ? 1 : 0);
  if (kind >= waiting_.size()) waiting_.resize(kind + 1);
  auto& of_kind = waiting_[kind];
  if (of_kind.empty() || of_kind.back()->count == k_wave) {
    if (free_.empty()) free_.push_back(std::make_unique<Rays>());
    of_kind.push_back(std::move(free_.back()));
    free_.pop_back();
    Rays& rays = *of_kind.back();
    rays.count = 0;
    rays.level = level;
    rays.from_eye = false;
  }
  return *of_kind.back();
}

std::unique_ptr<Rays> Waves::take() {
  const auto first_of = [](auto& of_kind) {
    std::unique_ptr<Rays> wave = std::move(of_kind.front());
    of_kind.erase(of_kind.begin());
    return wave;
  };
  for (auto of_kind = waiting_.rbegin(); of_kind != waiting_.rend(); ++of_kind) {
    if (!of_kind->empty() && of_kind->front()->count == k_wave) return first_of(*of_kind);
  }
  for (auto& of_kind : waiting_) {
    if (!of_kind.empty()) return first_of(of_kind);
  }
  return nullptr;
}

}  // namespace lancer::tracer
