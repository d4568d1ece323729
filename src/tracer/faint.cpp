#include "tracer/faint.hpp"

#include <algorithm>
#include <utility>

namespace lancer::tracer {
namespace {

bool is_within(Color c, Color limit) { return c.r <= limit.r && c.g <= limit.g && c.b <= limit.b; }

}  // namespace

bool Allowance::takes(Color most) {
  constexpr double k_part = 1.0 / 16;
  if (!is_within(most, left_ * k_part)) return false;
  left_ = left_ - most;
  return true;
}

void PendingRays::clear() {
  queue_.clear();
  rays_.clear();
  free_.clear();
  total_ = {};
}

void PendingRays::push(Pending ray, Color most) {
  std::uint32_t place = 0;
  if (free_.empty()) {
    place = static_cast<std::uint32_t>(rays_.size());
    rays_.push_back(std::move(ray));
  } else {
    place = free_.back();
    free_.pop_back();
    rays_[place] = std::move(ray);
  }
  queue_.push_back({max_component(most), place, most});
  std::push_heap(queue_.begin(), queue_.end(), is_fainter);
  total_ += most;
}

Pending PendingRays::pop() {
  std::pop_heap(queue_.begin(), queue_.end(), is_fainter);
  const Entry entry = queue_.back();
  queue_.pop_back();
  total_ = total_ - entry.most;
  free_.push_back(entry.place);
  return std::move(rays_[entry.place]);
}

bool PendingRays::fit(Color allowed) {
  if (!is_within(total_, allowed)) return false;
  // Added up anew: the running total has lost some digits.
  total_ = {};
  for (const Entry& entry : queue_) total_ += entry.most;
  return is_within(total_, allowed);
}

}  // namespace lancer::tracer
