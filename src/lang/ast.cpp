#include "lang/ast.hpp"

#include <algorithm>
#include <cstring>

namespace lancer::ast {
namespace {
constexpr std::size_t k_block_bytes = 64 * 1024;
}

void* Arena::allocate(std::size_t bytes, std::size_t alignment) {
  const auto address = reinterpret_cast<std::uintptr_t>(next_);
  std::size_t padding = (alignment - address % alignment) % alignment;
  if (next_ == nullptr || static_cast<std::size_t>(end_ - next_) < padding + bytes) {
    const std::size_t size = std::max(k_block_bytes, bytes + alignof(std::max_align_t));
    blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(size));
    next_ = blocks_.back().get();
    end_ = next_ + size;
    padding = 0;
  }
  std::byte* out = next_ + padding;
  next_ = out + bytes;
  return out;
}

std::string_view Arena::text(std::string_view s) {
  if (s.empty()) return {};
  char* out = static_cast<char*>(allocate(s.size(), 1));
  std::memcpy(out, s.data(), s.size());
  return {out, s.size()};
}

std::string_view symbol(BinaryOp op) {
  switch (op) {
    case BinaryOp::add: return "+";
    case BinaryOp::subtract: return "-";
    case BinaryOp::multiply: return "*";
    case BinaryOp::divide: return "/";
    case BinaryOp::modulo: return "%";
  }
  return "";
}

}  // namespace lancer::ast
