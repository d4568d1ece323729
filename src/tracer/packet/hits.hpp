#pragma once
// The rays of a wave, what they met, and how that is lit.

#include <array>

#include "tracer/packet/kernels.hpp"
#include "tracer/shade.hpp"
#include "tracer/surface.hpp"

namespace lancer::tracer {

struct Rays {
  std::size_t count = 0;
  Vec3s origin, direction;
  Starts starts;
  Column<Contact> contact;  // what it leaves, where starts.primitive is one
  Colors share;
  Column<std::uint16_t> pixel;

  /// The ray as it is by itself.
  Ray ray(std::size_t i, bool from_eye) const;
};

/// How hits land: by a kernel for all of a kind, or one by one.
enum class Ground : std::uint8_t { sphere, plane_x, plane_y, plane_z, facet, other };
inline constexpr std::size_t k_grounds = 6;
Ground ground(const World& world, std::uint32_t primitive);

/// Hits, those on a kind of ground after each other from a multiple of four on. Places in between are not
/// `there`.
struct Hits {
  std::size_t count = 0;
  std::array<std::size_t, k_grounds> first{}, on{};  // of each kind of ground: where, and how many
  Column<std::uint16_t> ray;                         // of Rays
  Vec3s origin, direction;                           // of the ray
  Numbers start_error;
  Column<std::uint32_t> primitive;
  Words entering;
  Numbers t, error;  // of the root; once landed, of the point
  Vec3s point, normal;
  Words there, settled;
  Column<std::uint8_t> face;

  Words primitive_word, shape, convex;
  Column<const MaterialNeeds*> needs;
  Vec3s facing;  // the normal that faces the ray
  Colors own, diffuse, specular, reflection;
  Numbers shininess;
  bool any_specular = false;

  /// The surface at the hit, for a ray that starts there on the given side of it.
  Contact contact(const World& world, std::size_t i, bool inside, bool left) const;
  Hit hit(const World& world, std::size_t i) const;
};

/// Room for what one light does.
struct Lighting {
  Vec3s towards;
  Numbers distance, n_dot_l, n_dot_h, highlight;
  Words known, asked;
  Starts starts;
  Colors arriving, sent;
  Column<Outlook> seen;
};

/// Fills in what the surfaces at the hits are.
void find_surfaces(const Tracing& tracing, Hits& hits, bool follow, Stats& stats);
/// Adds what all lights send there to the hits' own light.
void add_lights(const Tracing& tracing, const Scenery& scenery, Hits& hits, Lighting& room, Stats& stats);

}  // namespace lancer::tracer
