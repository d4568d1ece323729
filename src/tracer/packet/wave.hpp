#pragma once
// Rays in columns, one number of all rays after the other, as the kernels work on them four at a time.

#include <array>
#include <cstddef>
#include <cstdint>

#include "tracer/numeric.hpp"
#include "tracer/ray.hpp"
#include "tracer/tree/node.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

/// The most rays that go together, and how many of them search the tree together.
inline constexpr std::size_t k_wave = 512, k_group = 16;

template <class T>
struct alignas(32) Column {
  std::array<T, k_wave + k_group> at;  // with room for the lanes behind the last ray

  T& operator[](std::size_t i) { return at[i]; }
  const T& operator[](std::size_t i) const { return at[i]; }
};
using Numbers = Column<double>;
using Words = Column<long long>;

struct Vec3s {
  Numbers x, y, z;

  Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, Vec3 v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};
struct Colors {
  Numbers r, g, b;

  Color operator[](std::size_t i) const { return {r[i], g[i], b[i]}; }
  void set(std::size_t i, Color c) {
    r[i] = c.r;
    g[i] = c.g;
    b[i] = c.b;
  }
};

inline constexpr long long k_no_primitive = -1;

/// A primitive and, of a box, its face, in one word.
constexpr long long with_face(std::uint32_t primitive, int face) {
  return static_cast<long long>(face) << 32 | static_cast<long long>(primitive);
}
constexpr std::uint32_t primitive_of(long long word) { return static_cast<std::uint32_t>(word); }
constexpr std::uint8_t face_of(long long word) { return static_cast<std::uint8_t>(word >> 32); }

/// What a ray that leaves one surface, or none, remembers of its start; see Contact.
struct Starts {
  Numbers error;    // the ray's origin_error
  Words primitive;  // that it leaves; k_no_primitive: none
  Words shape;      // of that one
  Numbers rise;     // |normal . direction| there
  Words passes;     // all bits: it runs inside the convex solid that it starts on
  Words open;       // its open solids, as a place in the table of those
};

/// Where rays leave the convex solids that they start on and run inside of.
struct Exits {
  Numbers t, error;
  Words primitive;  // with its face
  Words known;      // all bits; none: to be asked by itself
};

/// A list of open solids for kernels: no more than a few shapes, or it is left to single rays.
struct OpenRow {
  static constexpr std::size_t k_most = 4;
  std::array<long long, k_most> shape{-1, -1, -1, -1};  // -1: none
  bool is_whole = true;
};

/// What a search says of a ray. Of a ray in doubt nothing is known: it is asked by itself.
enum class Outlook : std::uint8_t { nothing, surface, in_doubt };

/// The first surface of each ray.
struct FirstHits {
  Column<Outlook> seen;
  Words primitive;   // with its face
  Words entering;    // all bits, or none
  Numbers t, error;  // of its root
};

/// What a primitive's shadow is: none, black, what its one transmission leaves each time it is crossed, or
/// for single rays to tell.
enum class Shade : std::uint8_t { none, black, filtered, unclear };

/// The solids of one transmission that shadow rays go through.
struct Filters {
  static constexpr std::size_t k_most = 4;
  Column<std::uint8_t> count;
  Column<std::array<std::uint32_t, k_most>> crossed;  // 2 primitive, + 1 where both in and out
};

/// What kernels read of the world.
struct Scenery {
  const World* world = nullptr;
  const Node* nodes = nullptr;  // null: all primitives are listed
  const Frame* frames = nullptr;
  const std::uint32_t* items = nullptr;
  const std::uint32_t* bounded = nullptr;
  const std::uint32_t* listed = nullptr;
  std::size_t listed_count = 0;
  const Primitive* primitives = nullptr;
  const SpherePrimitive* spheres = nullptr;
  const PlanePrimitive* planes = nullptr;
  const FacetPrimitive* facets = nullptr;
  const BoxPrimitive* boxes = nullptr;
  const Shade* shade = nullptr;  // of each primitive
  bool has_facets = false;
};

/// What was done, as Stats counts it.
struct Work {
  std::uint64_t shape_tests = 0, node_visits = 0;
  std::uint64_t unclear = 0;  // shadow rays that are neither lit nor blocked
};

}  // namespace lancer::tracer
