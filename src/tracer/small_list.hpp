#pragma once
// A list of plain values that is nearly always short: the first N live in place, more move to the heap. What
// it does not hold costs nothing: it is neither set nor copied.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

namespace lancer::tracer {

template <class T, std::uint32_t N>
class SmallList {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  SmallList() {}
  SmallList(const SmallList& other) { copy(other); }
  SmallList(SmallList&& other) noexcept { take(other); }
  SmallList& operator=(const SmallList& other) {
    if (this != &other) copy(other);
    return *this;
  }
  SmallList& operator=(SmallList&& other) noexcept {
    if (this != &other) take(other);
    return *this;
  }
  ~SmallList() = default;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* begin() { return far_ ? far_.get() : near_; }
  T* end() { return begin() + size_; }
  const T* begin() const { return far_ ? far_.get() : near_; }
  const T* end() const { return begin() + size_; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& operator[](std::size_t i) const { return begin()[i]; }
  const T& back() const { return begin()[size_ - 1]; }

  void push_back(const T& value) {
    if (size_ < capacity_) {
      std::construct_at(end(), value);
    } else {
      grow(value);
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
  void shrink(std::size_t count) { size_ = static_cast<std::uint32_t>(count); }
  void clear() { size_ = 0; }

 private:
  [[gnu::noinline, gnu::cold]] void grow(const T& value) {
    std::unique_ptr<T[]> more(new T[std::size_t{capacity_} * 2]);
    std::copy_n(begin(), size_, more.get());
    more[size_] = value;
    far_ = std::move(more);
    capacity_ *= 2;
  }

  /// None or one, as nearly always, without a call.
  void copy(const SmallList& other) {
    if (far_ || other.size_ > 1) return copy_several(other);
    if (other.size_ == 1) std::construct_at(near_, *other.begin());
    size_ = other.size_;
  }

  [[gnu::noinline]] void copy_several(const SmallList& other) {
    if (other.size_ > capacity_) {
      far_.reset(new T[other.capacity_]);
      capacity_ = other.capacity_;
    }
    std::copy_n(other.begin(), other.size_, begin());
    size_ = other.size_;
  }

  void take(SmallList& other) {
    if (other.far_) {
      far_ = std::move(other.far_);
      capacity_ = std::exchange(other.capacity_, N);
      size_ = std::exchange(other.size_, 0);
    } else {
      copy(other);
    }
  }

  std::unique_ptr<T[]> far_;  // all of them, once there were more than N
  std::uint32_t size_ = 0, capacity_ = N;
  union {
    T near_[N];
  };
};

}  // namespace lancer::tracer
