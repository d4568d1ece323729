#pragma once
// A list of plain values that is nearly always short: the first N live in place, more move to the heap.

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace lancer::tracer {

template <class T, std::size_t N>
class SmallList {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* begin() { return spilled_.empty() ? near_.data() : spilled_.data(); }
  T* end() { return begin() + size_; }
  const T* begin() const { return spilled_.empty() ? near_.data() : spilled_.data(); }
  const T* end() const { return begin() + size_; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& operator[](std::size_t i) const { return begin()[i]; }
  const T& back() const { return begin()[size_ - 1]; }

  void push_back(const T& value) {
    if (spilled_.empty() && size_ < N) {
      near_[size_] = value;
    } else {
      const T copy = value;
      if (spilled_.empty()) spilled_.assign(near_.begin(), near_.end());
      spilled_.resize(size_);
      spilled_.push_back(copy);
    }
    ++size_;
  }

  /// Removes the element at place i; those behind it move up.
  void erase(std::size_t i) {
    T* const data = begin();
    for (std::size_t k = i + 1; k < size_; ++k) data[k - 1] = data[k];
    --size_;
  }

  /// Keeps the first `count` elements.
  void shrink(std::size_t count) { size_ = count; }
  void clear() { size_ = 0; }

 private:
  std::array<T, N> near_{};
  std::vector<T> spilled_;  // all of them, once there were more than N
  std::size_t size_ = 0;
};

}  // namespace lancer::tracer
