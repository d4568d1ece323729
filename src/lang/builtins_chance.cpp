// Chance without hidden state.

#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>

#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"

namespace lancer::lang {
namespace {

/// A bijection in which each bit of the result depends on each bit of `h`: the finish of MurmurHash3 (A.
/// Appleby) with the constants of D. Stafford's variant 13, as in splitmix64.
std::uint64_t stir(std::uint64_t h) {
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EB;
  return h ^ (h >> 31);
}

/// Scripts depend on these numbers: they never change.
std::uint64_t add(std::uint64_t hash, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value);  // -0 is 0
  return stir((hash + 0x9E3779B97F4A7C15) ^ stir(bits));
}

Value rand_of(const Arguments& a) {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].is(Type::number) && !a[i].is(Type::vector)) a.wrong_type(i, "a number or a vector");
    const int count = a[i].is(Type::number) ? 1 : a[i].dimension();
    for (int k = 0; k < count; ++k) hash = add(hash, a[i].component(k));
  }
  return static_cast<double>(hash >> 11) * 0x1p-53;
}

Value not_yet(const Arguments& a) {
  throw ScriptError(Code::not_yet, a.context().span, fmt::format("`{}` comes with a later version", a.id()),
                    "until then `rand(..)` gives numbers that look like chance");
}

constexpr std::array k_table{
    BuiltinInfo{"rand", "rand(a[, b[, c]])",
                "a number from 0 up to 1 that looks like chance, always the same for the same arguments", 1,
                3, rand_of},
    BuiltinInfo{"noise", "noise(p)", "gradient noise, -1 to 1", 1, 1, not_yet},
    BuiltinInfo{"fbm", "fbm(p, octaves = 4)", "noise of several sizes, summed", 1, 2, not_yet},
};

}  // namespace

std::span<const BuiltinInfo> chance_builtins() { return k_table; }

}  // namespace lancer::lang
