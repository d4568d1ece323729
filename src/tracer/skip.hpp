#pragma once
// What a render may leave out because the picture does not need it, by the names that users know. Each can be
// turned off; the picture is then the same, bit for bit, and takes longer. `faint-rays` and `faint-lights`
// alone cost something: no more than a part of the error asked for.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace lancer::tracer {

enum class Skip : std::uint8_t {
  any_hit,       // shadow rays go on behind the first opaque surface
  dark_lights,   // shadow rays to lights that are black, behind the surface, or aimed elsewhere
  faint_lights,  // shadow rays to lights too weak to show
  faint_rays,    // reflected and refracted rays too weak to show
  media,         // lists of the solids that a ray is inside of
  patterns,      // colours that no term needs
  recursion,     // looking for rays to go on with
  shadow_rays,   // all of them
  single_rays,   // tracing each ray by itself
  tree,          // a tree over few shapes
  zero_terms,    // light on surfaces that send none of it back
};
inline constexpr std::array<std::string_view, 11> k_skip_names{
    "any-hit",   "dark-lights", "faint-lights", "faint-rays", "media",     "patterns",
    "recursion", "shadow-rays", "single-rays",  "tree",       "zero-terms"};

constexpr std::string_view name_of(Skip skip) { return k_skip_names[static_cast<std::size_t>(skip)]; }

/// What is spared: a phrase that the reason follows.
constexpr std::string_view what_of(Skip skip) {
  switch (skip) {
    case Skip::any_hit: return "what lies behind the first surface in the way of a light";
    case Skip::dark_lights:
      return "shadow rays to lights that are black, behind the surface or aimed elsewhere";
    case Skip::faint_lights: return "shadow rays to lights too weak to show";
    case Skip::faint_rays: return "reflected and refracted rays too weak to show";
    case Skip::media: return "lists of the solids that a ray is inside of";
    case Skip::patterns: return "patterned colours that no term needs";
    case Skip::recursion: return "rays that go on from a surface";
    case Skip::shadow_rays: return "shadow rays";
    case Skip::single_rays: return "tracing each ray by itself";
    case Skip::tree: return "a tree of boxes";
    case Skip::zero_terms: return "lights at points that send none of them back";
  }
  return "";
}

constexpr std::optional<Skip> skip_from_name(std::string_view name) {
  for (std::size_t i = 0; i < k_skip_names.size(); ++i) {
    if (k_skip_names[i] == name) return static_cast<Skip>(i);
  }
  return std::nullopt;
}

/// A set of skips.
class Skips {
 public:
  static constexpr Skips all() { return Skips((1U << k_skip_names.size()) - 1); }
  static constexpr Skips none() { return Skips(0); }

  constexpr bool has(Skip skip) const { return (bits_ & bit(skip)) != 0; }
  constexpr Skips with(Skip skip) const { return Skips(bits_ | bit(skip)); }
  constexpr Skips without(Skip skip) const { return Skips(bits_ & ~bit(skip)); }
  friend constexpr bool operator==(const Skips&, const Skips&) = default;

 private:
  constexpr explicit Skips(unsigned bits) : bits_(bits) {}
  static constexpr unsigned bit(Skip skip) { return 1U << static_cast<unsigned>(skip); }
  unsigned bits_;
};

}  // namespace lancer::tracer
