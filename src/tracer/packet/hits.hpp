#pragma once
// What the rays of a wave met, and how that is lit.

#include <array>

#include "tracer/packet/kernels.hpp"
#include "tracer/packet/looks.hpp"
#include "tracer/packet/open_lists.hpp"
#include "tracer/packet/waves.hpp"
#include "tracer/shade.hpp"

namespace lancer::tracer {

/// The ray as it is by itself.
Ray single_ray(const World& world, const Rays& rays, std::size_t i, const OpenLists& lists);

/// The surface at the start of a ray that leaves it, or only touches it; `inside`: the ray starts on the side
/// that the normal points away from.
Contact contact_at(const World& world, std::uint32_t primitive, std::uint8_t face, Vec3 normal, bool inside,
                   bool left);

/// Hits, those on a kind of ground after each other from a multiple of four on. Places in between are not
/// `there`.
struct Hits {
  std::size_t count = 0;
  std::array<std::size_t, k_grounds> first{}, on{};  // of each kind of ground: where, and how many
  // Of the rays.
  Column<std::uint16_t> ray;  // its place in the wave
  Vec3s origin, direction;
  Numbers start_error;
  Colors share;
  Column<std::uint32_t> term;
  Words open;
  Words exits;  // all bits: it is the way out of the solid that the ray starts on
  // What was found.
  Column<std::uint32_t> primitive;
  Column<std::uint8_t> face;
  Words entering;
  Numbers t, error;  // of the root; once landed, of the point
  Vec3s point, normal;
  Words there, settled;
  // The surfaces.
  Words primitive_word, shape, convex;
  Words direct, onward;  // whether lights are asked there, and rays go on
  Vec3s facing;          // the normal that faces the ray
  Colors own, diffuse, specular, reflection, transmission;
  Numbers shininess;
  Words fresnel;
  bool any_specular = false, any_transmission = false;

  Hit hit(const World& world, std::size_t i) const;
};

/// Room for what one light does.
struct Lighting {
  Vec3s towards;
  Numbers distance, n_dot_l, n_dot_h, highlight;
  Words known, asked, shiny, lit;
  Starts starts;
  Exits exits;
  Colors arriving, sent;
  Column<Outlook> seen;
  Filters filters;
};

/// Rays that turn off at hits in one way.
struct Turned {
  Vec3s direction;
  Colors share;
  Numbers rise;  // as in Starts
  Words passes, inside, open;
  Words goes;  // all bits: there is such a ray, black as it may be
};
struct Onward {
  Turned mirrored, bent;
  Numbers from, to, reflectance;  // refractive indices
  Words known, total;
  Words beyond;  // the open solids behind the surface
};

/// Fills in what the surfaces at the hits are.
void find_surfaces(const Tracing& tracing, const Looks& looks, Hits& hits, bool follow, Stats& stats);
/// Adds what all lights send there to the hits' own light.
void add_lights(const Tracing& tracing, const Scenery& scenery, Hits& hits, Lighting& room, Stats& stats);

}  // namespace lancer::tracer
