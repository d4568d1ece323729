#pragma once
// Random numbers that are functions of what they are for: the same on every machine, thread and run.

#include <cstdint>

namespace lancer::tracer {

using Word = std::uint32_t;

/// Mixes all bits into all bits (the finaliser of MurmurHash3).
constexpr Word mixed(Word x) {
  x ^= x >> 16;
  x *= 0x85EBCA6BU;
  x ^= x >> 13;
  x *= 0xC2B2AE35U;
  return x ^ (x >> 16);
}

constexpr Word hash(Word a, Word b) { return mixed(a * 0x9E3779B9U + mixed(b + 0x7F4A7C15U)); }

/// In [0, 1).
constexpr double fraction(Word bits) { return bits * 0x1p-32; }

}  // namespace lancer::tracer
