#pragma once
// Colours that depend on the point, looked up in the space of the shape that wears them.

#include "scene/scene.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

/// A point in a shape's own space, to twice the precision, and how far, at most, rounding moved each
/// coordinate.
struct OwnPoint {
  Vec3 point;
  Vec3 error;
  Vec3 rest{};  // what is below the point's last bits
};

/// A point of the world's own space, off by at most `error`, in the space of the shape before its transform.
OwnPoint own_point(const World& world, std::uint32_t shape, Vec3 p, double error);

/// How far rounding may have moved p, a point that was projected on the primitive, off its surface.
double pattern_error(const World& world, std::uint32_t primitive, Vec3 p);

/// A coordinate within its error of a cell boundary belongs to the cell above it, so that a face in a
/// boundary has one colour.
Color color_at(const scene::Pattern& pattern, const OwnPoint& at);

inline Color color_at(const scene::Scene& scene, const scene::Texture& texture, const OwnPoint& at) {
  return texture.pattern == scene::k_none ? texture.color : color_at(scene.patterns[texture.pattern], at);
}

/// No light at any point?
bool is_black(const scene::Scene& scene, const scene::Texture& texture);

/// Does any colour of the material depend on the point?
bool has_pattern(const scene::Material& material);

}  // namespace lancer::tracer
