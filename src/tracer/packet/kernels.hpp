#pragma once
// What is done to many rays at once, in two versions of the same bits (see shapes/lanes.hpp). `count` rays,
// or hits, begin at place 0 of the columns, or at `first`, a multiple of four; columns hold numbers that are
// safe to compute with up to the next multiple of k_group.

#include "base/color.hpp"
#include "tracer/packet/wave.hpp"
#include "tracer/processor.hpp"

namespace lancer::tracer {

/// Rays as searches read them. Null `starts`: they start on no surface.
struct RaysView {
  const Vec3s* origin;
  const Vec3s* direction;
  const Starts* starts;
  std::size_t count;
};

/// Shadow rays; all columns are the hits'.
struct ShadowsView {
  RaysView rays;
  const Words* asked;       // all bits, or none
  const Numbers* distance;  // of the light
};

/// Hits on one kind of surface: where their rays start and what was found.
struct LandingView {
  const Vec3s* origin;
  const Vec3s* direction;
  const Numbers* start_error;
  const std::uint32_t* primitive;
  const Words* entering;
  std::size_t first, count;
  // Found there; filled in. `settled`: all bits, or none where the ray has to be asked by itself.
  Numbers* t;
  Numbers* error;  // first of the root, then of the point
  Vec3s* point;
  Vec3s* normal;
  Words* settled;
};

/// A light as hits see it; `known` is none where a lane has to be asked by itself.
struct LightView {
  bool is_sun;
  Vec3 at;  // of a sun the unit vector towards it
  const Vec3s* point;
  const Vec3s* facing;  // the normal that faces the ray
  const Vec3s* normal;  // outward
  const Words* convex;  // all bits: the hit is on a convex solid
  Vec3s* towards;
  Numbers* distance;
  Numbers* n_dot_l;
  Words* known;
  Numbers* rise;  // as in Starts, of the ray to the light
  Words* passes;
};

/// The light that hits send back along their rays: arriving (diffuse n.l + specular highlight).
struct SentView {
  const Colors* diffuse;
  const Colors* specular;
  const Colors* arriving;
  const Numbers* n_dot_l;
  const Numbers* highlight;
  Colors* sent;
};

#define LANCER_PACKETS(TARGET)                                                                           \
  namespace TARGET {                                                                                     \
  void find_closest(const Scenery&, const RaysView&, FirstHits&, Work&);                                 \
  void find_blocked(const Scenery&, const ShadowsView&, Column<Outlook>&, Work&);                        \
  void land_on_spheres(const Scenery&, const LandingView&);                                              \
  void land_across(const Scenery&, int axis, const LandingView&);                                        \
  void land_on_facets(const Scenery&, const LandingView&);                                               \
  void look_at_light(const LightView&, std::size_t count);                                               \
  void halfway(const Vec3s& normal, const Vec3s& direction, const Vec3s& towards, Numbers& n_dot_h,      \
               Words& known, std::size_t count);                                                         \
  void powers(const Numbers& x, const Numbers& y, Numbers& out, Words& certain, std::size_t count);      \
  void send(const SentView&, std::size_t count);                                                         \
  void mirror(const Vec3s& direction, const Vec3s& normal, Vec3s& out, Words& known, std::size_t count); \
  }
LANCER_PACKETS(baseline)
#if defined(LANCER_HAS_AVX2)
LANCER_PACKETS(avx2)
#endif
#undef LANCER_PACKETS

#if defined(LANCER_HAS_AVX2)
#define LANCER_ON_TARGET(CALL) (k_use_avx2 ? avx2::CALL : baseline::CALL)
#else
#define LANCER_ON_TARGET(CALL) baseline::CALL
#endif

/// The first root ahead of a single ray, for kinds that have no kernel.
struct FirstRoot {
  bool met = false, in_doubt = false, entering = false;
  double t = 0, error = 0;
};
FirstRoot first_root(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction);
/// lo, then hi.
void own_bounds(const World& world, std::uint32_t primitive, double* box);

}  // namespace lancer::tracer
