#pragma once
// An upper bound of the radiance that can come along any ray of a scene, and what of it can be seen. With it
// a ray that could not change the picture visibly need not be followed.

#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace lancer::tracer {

/// A light with falloff that may be arbitrarily near to a shape that it lights: then there is no bound.
struct NearLamp {
  scene::Index light = 0, shape = 0;
};

/// The most that a ray can bring.
class Brightness {
 public:
  /// Shadows are taken to darken: no transmission is above 1 where they are filtered. Everything that the
  /// formula of a surface's radiance can add up to, over all shapes of the scene and all of their points:
  /// ambient, each light with n.l and the highlight at 1 and no shadow (with falloff: at the least distance
  /// of the light from the shape), the background, and mirrored and refracted light of the same bound, one
  /// deviation less deep. Work: shapes times lights with falloff.
  explicit Brightness(const scene::Scene& scene);
  Brightness() = default;

  const std::optional<NearLamp>& near_lamp() const { return near_lamp_; }

  /// Of a ray of which `depth` more deviations are followed; infinite where there is no bound.
  Color bound(int depth) const;

 private:
  std::vector<Color> bound_;  // by depth; deeper than its end: beyond_
  Color beyond_;
  std::optional<NearLamp> near_lamp_;
};

/// The largest components that the texture has at any point.
Color largest(const scene::Scene& scene, const scene::Texture& texture);

/// How much less light may come to a pixel than it shows, linear, without its display value changing by more
/// than 1, per unit: where the display curve sRGB has slope s at `shown` (0..1, after exposure), at most 1 /
/// s. Concave in `shown`, so that a pixel of many samples may apply it to each of them: the mean of the
/// losses is then within what the mean of the samples allows.
double tolerance(double shown);

}  // namespace lancer::tracer
