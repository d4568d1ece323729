#pragma once
// What a picture needs: decided once from the scene, before any ray is shot. Leaving something out never
// changes a bit of the picture; the reason is put in words for whoever asks why a render is fast or slow.

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "tracer/options.hpp"

namespace lancer::tracer {

enum class ShadowWork : std::uint8_t {
  none,      // every light reaches everything
  blocked,   // one question: is anything in between?
  filtered,  // the product of all transmissions in between
};

struct Plan {
  ShadowWork shadows = ShadowWork::filtered;
  bool reflects = true;              // some surface may send a ray back
  bool transmits = true;             // some surface may let one through
  bool media = true;                 // a ray's open solids matter, as some refractive indices differ
  std::vector<std::string> reasons;  // a sentence for each thing that is left out
};

Plan plan(const scene::Scene& scene, const scene::View& view, const Options& options);

}  // namespace lancer::tracer
