#include "lang/evaluate_frames.hpp"

#include <algorithm>

namespace lancer::lang {
namespace {
constexpr std::size_t k_chunk_slots = 4096;
}

Value* FrameStack::push(std::size_t count) {
  if (chunks_.empty() || chunks_[current_].size - chunks_[current_].used < count) {
    if (!chunks_.empty()) ++current_;
    if (current_ < chunks_.size() && chunks_[current_].size < count) chunks_.resize(current_);
    if (current_ == chunks_.size()) {
      const std::size_t size = std::max(k_chunk_slots, count);
      chunks_.push_back({std::make_unique<Value[]>(size), size, 0});
    }
  }
  Chunk& chunk = chunks_[current_];
  Value* out = chunk.slots.get() + chunk.used;
  chunk.used += count;
  return out;
}

void FrameStack::pop(Mark mark) {
  if (chunks_.empty()) return;
  while (current_ > mark.chunk) chunks_[current_--].shrink(0);
  chunks_[current_].shrink(mark.used);
}

void FrameStack::Chunk::shrink(std::size_t to) {
  while (used > to) slots[--used] = Value();
}

Ref<Box> BoxList::make() {
  Ref<Box> box(new Box);
  box->previous = &head_;
  box->next = head_.next;
  if (head_.next != nullptr) head_.next->previous = box.get();
  head_.next = box.get();
  return box;
}

void BoxList::clear() {
  while (head_.next != nullptr) {
    const Ref<Box> box(head_.next);
    box->unlink();
    box->value = Value();
  }
}

}  // namespace lancer::lang
