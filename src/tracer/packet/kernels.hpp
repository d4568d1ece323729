#pragma once
// What is done to many rays at once, in two versions of the same bits (see shapes/lanes.hpp). `count` rays,
// or hits, begin at place 0 of the columns, or at `first`, a multiple of four; columns hold numbers that are
// safe to compute with up to the next multiple of k_group.

#include "base/color.hpp"
#include "tracer/camera.hpp"
#include "tracer/packet/looks.hpp"
#include "tracer/packet/wave.hpp"
#include "tracer/processor.hpp"

namespace lancer::tracer {

/// Rays as searches read them. Null `starts`: they start on no surface; `exits`: of those that run inside a
/// solid; null `open`: they are inside of no other.
struct RaysView {
  const Vec3s* origin;
  const Vec3s* direction;
  const Starts* starts;
  const Exits* exits;
  const OpenRow* open;  // what starts->open are places in
  std::size_t count;
};

/// Shadow rays; all columns are the hits'.
struct ShadowsView {
  RaysView rays;
  const Words* asked;       // all bits, or none
  const Numbers* distance;  // of the light
};

/// What came of them; `filters` where nothing is in the way but what lets light through.
struct ShadowsSeen {
  Column<Outlook>* seen;
  Words* lit;  // all bits: asked, and nothing at all is in the way
  Filters* filters;
};

/// Hits on one kind of surface: where their rays start and what was found.
struct LandingView {
  const Vec3s* origin;
  const Vec3s* direction;
  const Numbers* start_error;
  const std::uint32_t* primitive;
  const Words* entering;
  const Column<std::uint8_t>* face;  // of boxes
  const Words* exits;                // all bits: it is the way out of the solid that the ray starts on
  std::size_t first, count;
  // Found there; filled in. `settled`: all bits, or none where the ray has to be asked by itself.
  Numbers* t;
  Numbers* error;  // first of the root, then of the point
  Vec3s* point;
  Vec3s* normal;
  Words* settled;
};

/// Where the colours of hits go; null: not needed.
struct PaintView {
  Colors* own;
  Colors* diffuse;
  Colors* specular;
  Colors* reflection;
  Colors* transmission;
};

/// A light as hits see it; `known` is none where a lane has to be asked by itself.
struct LightView {
  bool is_sun;
  Vec3 at;  // of a sun the unit vector towards it
  const Vec3s* point;
  const Vec3s* facing;  // the normal that faces the ray
  const Vec3s* normal;  // outward
  const Words* convex;  // all bits: the hit is on a convex solid
  const Words* direct;  // all bits: it sends some of the light back
  Vec3s* towards;
  Numbers* distance;
  Numbers* n_dot_l;
  Words* known;
  Words* asked;   // all bits: it does, and the light is in front of it
  Numbers* rise;  // as in Starts, of the ray to the light
  Words* passes;
};

/// Where light goes on through surfaces, between the refractive indices `from` and `to`; see optics.hpp.
struct BentView {
  const Words* asked;  // all bits: rays go on
  const Vec3s* direction;
  const Vec3s* facing;  // the normal that faces the ray
  const Numbers* from;
  const Numbers* to;
  Vec3s* bent;
  Words* total;          // all bits: under total reflection there is no such way
  Words* known;          // none: the direction has to be asked for by itself
  Numbers* reflectance;  // by Fresnel's formulas
};

/// What highlights depend on; only where `asked` is all bits.
struct HalfwayView {
  const Vec3s* normal;
  const Vec3s* direction;
  const Vec3s* towards;
  const Words* asked;
};

/// The light that hits send back along their rays: arriving (diffuse n.l + specular highlight).
struct SentView {
  const Colors* diffuse;
  const Colors* specular;
  const Colors* arriving;  // null: `everywhere`
  Color everywhere;
  const Numbers* n_dot_l;
  const Numbers* highlight;
  Colors* sent;
  Words* asked;  // none where nothing is sent
};

/// Of what arrives where light goes on, how much counts at the pixel.
struct SharesView {
  const Colors* share;  // of the ray that came
  const Colors* reflection;
  const Colors* transmission;  // null: nothing is let through
  const Words* onward;         // all bits: rays go on
  const Words* fresnel;
  const Words* total;
  const Numbers* reflectance;
  Colors* reflected;  // shares
  Colors* transmitted;
  Words* reflects;  // all bits: there is such a ray, black as it may be
  Words* transmits;
};

/// Rays that start at hits.
struct TurnedView {
  const Vec3s* direction;
  const Vec3s* normal;
  const Words* convex;
  Numbers* rise;  // as in Starts
  Words* inside;  // all bits: it starts behind the surface
  Words* passes;
};

// Those that return a bool tell whether `known`, or `certain`, is all bits wherever it counts.
#define LANCER_PACKETS(TARGET)                                                                           \
  namespace TARGET {                                                                                     \
  void aim(const Aim&, const ScreenPoint*, std::size_t count, Vec3s& origin, Vec3s& direction,           \
           Words& known);                                                                                \
  void find_exits(const Scenery&, const RaysView&, const Words* asked, Exits&);                          \
  void find_closest(const Scenery&, const RaysView&, FirstHits&, Work&);                                 \
  void find_blocked(const Scenery&, const ShadowsView&, const ShadowsSeen&, Work&);                      \
  void land_on_spheres(const Scenery&, const LandingView&);                                              \
  void land_across(const Scenery&, int axis, const LandingView&);                                        \
  void land_on_facets(const Scenery&, const LandingView&);                                               \
  void land_on_tilted_planes(const Scenery&, const LandingView&);                                        \
  void land_on_turned_boxes(const Scenery&, const LandingView&);                                         \
  void land_on_boxes(const Scenery&, const LandingView&);                                                \
  void face_rays(const Vec3s& normal, const Words& entering, Vec3s& facing, std::size_t count);          \
  void paint(const Paint* const* paints, const PaintView&, std::size_t count);                           \
  bool look_at_light(const LightView&, std::size_t count);                                               \
  bool halfway(const HalfwayView&, Numbers& n_dot_h, Words& known, std::size_t count);                   \
  void find_shiny(const Words& asked, const Colors& specular, Words& shiny, std::size_t count);          \
  bool powers(const Numbers& x, const Numbers& y, const Words& asked, Numbers& out, Words& certain,      \
              std::size_t count);                                                                        \
  void send(const SentView&, std::size_t count);                                                         \
  void add_sent(const Colors& sent, const Words& where, Colors& sum, std::size_t count);                 \
  std::uint64_t count_set(const Words&, std::size_t count);                                              \
  void split(const SharesView&, std::size_t count);                                                      \
  void turn(const TurnedView&, std::size_t count);                                                       \
  bool mirror(const Vec3s& direction, const Vec3s& normal, const Words& asked, Vec3s& out, Words& known, \
              std::size_t count);                                                                        \
  bool bend(const BentView&, std::size_t count);                                                         \
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
  bool met = false, in_doubt = false, entering = false, crossed = false;
  double t = 0, error = 0;
};
FirstRoot first_root(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction);
/// exit() of a convex solid.
Root way_out(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction);
/// lo, then hi.
void own_bounds(const World& world, std::uint32_t primitive, double* box);

}  // namespace lancer::tracer
