#pragma once
// Where variables live while a script runs: frames of slots on one stack, and boxes for what closures share.

#include <cstddef>
#include <memory>
#include <vector>

#include "lang/value.hpp"

namespace lancer::lang {

/// A stack of values in chunks: a slot stays where it is while others come and go above it.
class FrameStack {
 public:
  struct Mark {
    std::size_t chunk, used;
  };

  /// `count` adjacent slots, each without a value.
  Value* push(std::size_t count);
  Mark mark() const { return {current_, chunks_.empty() ? 0 : chunks_[current_].used}; }
  /// Takes away what was pushed since `mark`.
  void pop(Mark mark);

 private:
  struct Chunk {
    std::unique_ptr<Value[]> slots;
    std::size_t size, used;
    void shrink(std::size_t to);
  };
  std::vector<Chunk> chunks_;
  std::size_t current_ = 0;
};

/// Makes boxes and knows those alive, so that closures which hold themselves in a circle are freed at the
/// end.
class BoxList {
 public:
  BoxList() = default;
  ~BoxList() { clear(); }
  BoxList(const BoxList&) = delete;
  BoxList& operator=(const BoxList&) = delete;

  Ref<Box> make();
  /// Empties every box.
  void clear();

 private:
  Box head_;  // the list hangs on it; never a variable itself
};

}  // namespace lancer::lang
