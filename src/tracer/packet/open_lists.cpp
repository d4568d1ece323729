#include "tracer/packet/open_lists.hpp"

#include <algorithm>

namespace lancer::tracer {

OpenLists::OpenLists(const World& world) : world_(world) { add({}); }

std::uint32_t OpenLists::crossed(std::uint32_t list, std::uint32_t shape, bool entering) {
  if (list == k_none && !entering) return k_none;
  for (const Change& change : lists_[list].changes) {
    if (change.shape == shape && change.entering == entering) return change.to;
  }
  OpenSolids open = lists_[list].open;
  cross(world_, open, shape, entering);
  const std::uint32_t to = find(open);
  lists_[list].changes.push_back({shape, entering, to});
  return to;
}

std::uint32_t OpenLists::find(const OpenSolids& open) {
  const auto is_it = [&](const List& list) {
    return std::equal(open.begin(), open.end(), list.open.begin(), list.open.end());
  };
  const auto at = std::find_if(lists_.begin(), lists_.end(), is_it);
  return at != lists_.end() ? static_cast<std::uint32_t>(at - lists_.begin()) : add(open);
}

std::uint32_t OpenLists::add(const OpenSolids& open) {
  OpenRow row;
  row.is_whole = open.size() <= OpenRow::k_most;
  for (std::size_t i = 0; i < std::min(open.size(), OpenRow::k_most); ++i) row.shape[i] = open[i];
  rows_.push_back(row);
  lists_.push_back({open, tracer::refractive_index(world_, open), {}});
  return static_cast<std::uint32_t>(lists_.size() - 1);
}

void OpenLists::tidy() {
  constexpr std::size_t k_many = 256;
  if (lists_.size() < k_many) return;
  lists_.clear();
  rows_.clear();
  add({});
}

}  // namespace lancer::tracer
