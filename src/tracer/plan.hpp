#pragma once
// What a picture needs: decided once from scene, view and options, before any ray is shot. Leaving something
// out never changes a bit of the picture (what is faint: no more than the error asked for allows); the reason
// is put in words for whoever asks why a render is fast or slow.

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "tracer/brightness.hpp"
#include "tracer/light_cells.hpp"
#include "tracer/options.hpp"

namespace lancer::tracer {

enum class ShadowWork : std::uint8_t {
  none,      // every light reaches everything
  blocked,   // one question: is anything in between?
  filtered,  // the product of all transmissions in between
};

/// What a material asks for, so that a surface costs only what its own terms need.
struct MaterialNeeds {
  bool direct = true;   // light may come back: the lights are asked
  bool onward = true;   // rays may go on from it
  bool pattern = true;  // some of the colours below, where they are needed at all, depend on the point
  /// Whose colour matters in this picture; the last two only where rays may go on.
  bool ambient = true, diffuse = true, specular = true, reflection = true, transmission = true;
};

/// Something in the scene that a reason names.
struct Thing {
  enum class Kind : std::uint8_t { shape, light };
  Kind kind = Kind::shape;
  scene::Index index = 0;
};

enum class Verdict : std::uint8_t {
  skipped,  // never done
  as_met,   // left out wherever a ray meets the case
  needed,   // looked at, and done
  off,      // could be left out, and is done because that was asked for
};

/// One skip, and what came of it.
struct Decision {
  Skip skip = Skip::any_hit;
  Verdict verdict = Verdict::needed;
  std::string reason;         // a clause, in which {} stands for the things
  std::vector<Thing> things;  // the first few
  std::size_t count = 0;      // of all of them
};

struct Plan {
  Skips skips = Skips::all();  // that are allowed; those that are decided where a ray meets the case ask here
  ShadowWork shadows = ShadowWork::filtered;
  bool any_hit = true;               // a shadow ray ends at the first surface that lets nothing through
  bool recursion = true;             // rays may go on from what they meet
  bool reflects = true;              // some surface may send a ray back
  bool transmits = true;             // some surface may let one through
  bool media = true;                 // a ray's open solids matter
  bool packets = false;              // rays of neighbouring pixels are traced together
  bool tree = true;                  // a tree over the primitives, in place of a list
  bool every_light = true;           // else only `lights`
  std::vector<scene::Index> lights;  // that may reach something, in order
  LightCellPlan light_cells;         // where many lights reach a part of the scene only
  bool faint_rays = false;           // those that cannot show are not followed
  bool faint_lights = false;         // shadow rays to lights that cannot show are not shot
  double faint_error = 0;            // that all of these may add up to in a pixel, display units
  double exposure = 1;
  Brightness brightness;             // for faint_rays
  std::vector<MaterialNeeds> needs;  // of each material; empty: everything
  std::vector<Decision> decisions;   // one for each skip, in the order of their names
  std::uint64_t worn = 0;            // materials that some shape wears
  std::uint64_t primitives = 0;      // that a tree or list would hold

  const MaterialNeeds& needs_of(scene::Index material) const {
    return material < needs.size() ? needs[material] : k_everything;
  }
  static constexpr MaterialNeeds k_everything{};
};

/// A pure function of what it is given.
Plan plan(const scene::Scene& scene, const scene::View& view, const Options& options);

/// The reason with its things by name (`` `ball` ``), or kind and number among those without one (`sphere
/// 2`).
std::string in_words(const scene::Scene& scene, const Decision& decision);

/// Of the error asked for: all that is left out for being faint adds up to no more.
inline constexpr double k_faint_part = 1.0 / 8;

/// Up to this many primitives a list is asked faster than a tree; spheres, tested four at a time, and planes
/// may be more, and so may things of all kinds where all rays go together.
inline constexpr std::uint64_t k_longest_list = 4, k_longest_list_of_spheres = 8, k_longest_packet_list = 16;

}  // namespace lancer::tracer
