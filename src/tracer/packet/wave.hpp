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
inline constexpr std::size_t k_wave = 256, k_group = 16;

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

/// What a ray that leaves one surface, or none, remembers of its start; see Contact.
struct Starts {
  Numbers error;    // the ray's origin_error
  Words primitive;  // that it leaves; k_no_primitive: none
  Words shape;      // of that one
  Numbers rise;     // |normal . direction| there
  Words passes;     // all bits: it runs inside a convex solid
};

/// What a search says of a ray. Of a ray in doubt nothing is known: it is asked by itself.
enum class Outlook : std::uint8_t { nothing, surface, in_doubt };

/// The first surface of each ray.
struct FirstHits {
  Column<Outlook> seen;
  Words primitive;
  Words entering;    // all bits, or none
  Numbers t, error;  // of its root
};

/// What a primitive's shadow is: none, black, or what its transmission leaves.
enum class Shade : std::uint8_t { none, black, filtered };

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
  const Shade* shade = nullptr;  // of each primitive
  bool has_facets = false;
};

/// What was done, as Stats counts it.
struct Work {
  std::uint64_t shape_tests = 0, node_visits = 0;
};

}  // namespace lancer::tracer
