#pragma once
// What the rays of pixels bring, kept until all is there: the sums are made in the order of single rays, of
// each ray first its own light, then what is let through, then what is reflected.

#include <cstdint>
#include <vector>

#include "base/color.hpp"

namespace lancer::tracer {

class LightTree {
 public:
  static constexpr std::uint32_t k_none = 0;  // the first term is no part of any other
  static constexpr std::uint32_t k_never = ~0U;

  struct Part {
    Color light;
    std::uint32_t transmitted = k_none, reflected = k_none;
    std::uint32_t late = k_never;  // else: which of the rays that wait to be followed one by one
  };

  std::size_t size() const { return all_.size(); }
  /// Of so many pixels.
  void begin(std::size_t count) {
    all_.clear();
    all_.resize(count);
  }
  std::uint32_t add() {
    all_.emplace_back();
    return static_cast<std::uint32_t>(all_.size() - 1);
  }
  /// One that belongs to that of a surface.
  std::uint32_t add(std::uint32_t surface, bool transmitted) {
    const std::uint32_t term = add();
    (transmitted ? all_[surface].transmitted : all_[surface].reflected) = term;
    return term;
  }
  Part& operator[](std::uint32_t i) { return all_[i]; }

  /// Calls add(term) for a term and all that belong to it.
  template <class Add>
  void each(std::uint32_t first, const Add& add) {
    left_.clear();
    for (std::uint32_t at = first;;) {
      const Part& term = all_[at];
      add(term);
      if (term.transmitted != k_none) {
        if (term.reflected != k_none) left_.push_back(term.reflected);
        at = term.transmitted;
      } else if (term.reflected != k_none) {
        at = term.reflected;
      } else if (!left_.empty()) {
        at = left_.back();
        left_.pop_back();
      } else {
        return;
      }
    }
  }

 private:
  std::vector<Part> all_;
  std::vector<std::uint32_t> left_;
};

}  // namespace lancer::tracer
