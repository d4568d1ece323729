#pragma once
// Pictures of scripts as Lancer draws them, in doubles, and their judgement by the reference tracer.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/color.hpp"
#include "picture.hpp"
#include "scene/scene.hpp"
#include "stress/stress.hpp"

namespace lancer::stress {

/// A script, evaluated. Throws std::runtime_error with its messages where it is wrong.
struct Script {
  explicit Script(const std::string& text);
  scene::Scene scene;
  scene::View view;  // its first
};

/// The radiance at each pixel's centre, rows from the top, as Lancer reckons it before rounding to floats.
/// Throws std::runtime_error where the rounded values are not those of tracer::render.
std::vector<Color> drawn(const scene::Scene& scene, const scene::View& view);

/// How a picture is judged.
struct Measures {
  double limit = 1e-7;              // a pixel that is off by more is wrong
  reference::Tolerance tolerance;   // what counts as coincident
  bool excuse_near_things = false;  // is a pixel in the band that hangs on the tolerance?
};

inline constexpr Measures k_near_excused{1e-7, {}, true};

/// What became of the pixels of some pictures.
struct Verdict {
  std::uint64_t pixels = 0, wrong = 0, in_band = 0;  // as in Measure
  double worst = 0;   // the largest error of the pixels that are not in the band
  std::string where;  // the picture and pixel that has it

  void add(const Verdict& other);
};

/// `name` is what the picture is called in Verdict::where.
Verdict judge(const std::string& name, const scene::Scene& scene, const scene::View& view,
              const Measures& measures);
Verdict judge(const std::string& name, const std::string& script, const Measures& measures);

/// A row's outcome: no wrong pixel, and no error above the limit.
Outcome outcome(const Verdict& verdict, const Measures& measures);

/// What scripts are called, and the scripts.
using Scripts = std::vector<std::pair<std::string, std::string>>;
/// That of all of them.
Outcome outcome(const Scripts& scripts, const Measures& measures);

}  // namespace lancer::stress
