#pragma once
// The lists of open solids of rays that go together, each kept once: a ray has a number in place of its list,
// and what changes it is looked up.

#include <cstdint>
#include <vector>

#include "tracer/media.hpp"
#include "tracer/packet/wave.hpp"

namespace lancer::tracer {

class OpenLists {
 public:
  explicit OpenLists(const World& world);

  /// The list of a ray outside of all solids.
  static constexpr std::uint32_t k_none = 0;

  /// As cross().
  std::uint32_t crossed(std::uint32_t list, std::uint32_t shape, bool entering);
  std::uint32_t find(const OpenSolids& open);

  const OpenSolids& open(std::uint32_t list) const { return lists_[list].open; }
  double refractive_index(std::uint32_t list) const { return lists_[list].index; }
  /// As kernels read them.
  const OpenRow* rows() const { return rows_.data(); }

  /// Forgets all where they have become many; then no ray may have one.
  void tidy();

 private:
  struct Change {
    std::uint32_t shape = 0;
    bool entering = false;
    std::uint32_t to = 0;
  };
  struct List {
    OpenSolids open;
    double index = 1;
    std::vector<Change> changes;  // those looked up before
  };

  std::uint32_t add(const OpenSolids& open);

  const World& world_;
  std::vector<List> lists_;
  std::vector<OpenRow> rows_;
};

}  // namespace lancer::tracer
