#include "tracer/pattern.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/numeric.hpp"
#include "tracer/shapes/linear_map.hpp"

namespace lancer::tracer {
namespace {

/// Is the number of the cell odd that holds `coordinate` + `rest`?
bool odd_cell(double coordinate, double rest, double error, double size) {
  const auto is_odd = [](double whole) { return std::fmod(whole, 2) != 0; };
  if (rest == 0) return is_odd(std::floor((coordinate + error) / size));
  const DoubleDouble cells = two_sum(coordinate, rest + error) / DoubleDouble{size, 0};
  const double most = std::floor(cells.hi), more = std::floor((cells.hi - most) + cells.lo);
  return is_odd(most) != is_odd(more);
}

Color checker(const scene::Pattern& pattern, const OwnPoint& at) {
  bool odd = false;
  for (int axis = 0; axis < 3; ++axis)
    odd ^= odd_cell(at.point[axis], at.rest[axis], at.error[axis], pattern.size);
  return odd ? pattern.b : pattern.a;
}

Color stripes(const scene::Pattern& pattern, const OwnPoint& at) {
  const Vec3 axis = normalize(pattern.axis);
  const double error = dot(abs(axis), at.error) + 4 * k_u * dot(abs(axis), abs(at.point));
  return odd_cell(dot(at.point, axis), dot(at.rest, axis), error, pattern.size) ? pattern.b : pattern.a;
}

Color gradient(const scene::Pattern& pattern, const OwnPoint& at) {
  const Vec3 way = pattern.to - pattern.from;
  const double size = length(way);
  const double t = std::clamp(dot((at.point - pattern.from) + at.rest, way / size) / size, 0.0, 1.0);
  return pattern.a * (1 - t) + pattern.b * t;
}

}  // namespace

OwnPoint own_point(const World& world, std::uint32_t shape, Vec3 p, double error) {
  const Transform& transform = world.scene->transforms[world.scene->shapes[shape].transform];
  const Place in_scene = Place{p, {}}.from(-world.origin);
  const Affine& map = transform.to_object;
  if (is_identity(map)) return {in_scene.at, {error, error, error}, in_scene.rest};
  // Relative to where the transform puts its space's origin: a far move leaves no rounding of its size.
  const Place offset = in_scene.from(transform.to_world.translation);
  const Place own = Affine{map.rows, {}, {}}.place({offset.at, offset.rest - transform.to_world.rest});
  Vec3 own_error = apply_abs(map.rows, abs(p) + abs(offset.at)) * (8 * k_u);
  for (int axis = 0; axis < 3; ++axis)
    own_error[axis] += sum_abs(map.rows[static_cast<std::size_t>(axis)]) * error;
  return {own.at, own_error, own.rest};
}

double pattern_error(const World& world, std::uint32_t primitive, Vec3 p) {
  return 8 * k_u * max_abs(p) + 4 * slack(world, primitive);
}

Color color_at(const scene::Pattern& pattern, const OwnPoint& at) {
  switch (pattern.kind) {
    case scene::Pattern::Kind::checker: return checker(pattern, at);
    case scene::Pattern::Kind::stripes: return stripes(pattern, at);
    case scene::Pattern::Kind::gradient: return gradient(pattern, at);
  }
  return {};
}

bool is_black(const scene::Scene& scene, const scene::Texture& texture) {
  if (texture.pattern == scene::k_none) return is_black(texture.color);
  const scene::Pattern& pattern = scene.patterns[texture.pattern];
  return is_black(pattern.a) && is_black(pattern.b);
}

bool has_pattern(const scene::Material& m) {
  const auto patterned = [](const scene::Texture& texture) { return texture.pattern != scene::k_none; };
  return patterned(m.ambient) || patterned(m.diffuse) || patterned(m.specular) || patterned(m.reflection) ||
         patterned(m.transmission);
}

}  // namespace lancer::tracer
