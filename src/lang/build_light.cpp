// Lights, suns and spots.

#include <fmt/format.h>

#include "base/number.hpp"
#include "lang/build_parts.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;

Vec3 spot_direction(Vec3 at, const Argument& target) {
  const Vec3 look_at = read_point(target);
  if (look_at == at) {
    throw ScriptError(Code::degenerate, target.span, "a spot does not look at its own place",
                      fmt::format("`at` and `look_at` are both {}", to_text(at)));
  }
  const Vec3 direction = look_at - at;
  if (!is_finite(direction)) {
    throw ScriptError(Code::not_finite, target.span, "from `at` to `look_at` is beyond the range of numbers");
  }
  return direction;
}

void read_cone(const BlockReader& reader, scene::Light& light) {
  light.direction = spot_direction(light.at, reader.need("look_at").one());
  if (const auto angle = reader.find("angle")) light.angle = read_opening(angle->one());
  if (const auto softness = reader.find("softness")) {
    light.softness = read_number(softness->one());
    if (light.softness < 0 || light.softness > 1) {
      refuse(Code::out_of_range, softness->one(), "lies from 0 to 1", lancer::to_text(light.softness));
    }
  }
}

}  // namespace

scene::Light build_light(const BlockReader& reader) {
  scene::Light light;
  if (const auto color = reader.find("color")) light.color = read_color(color->one());
  if (reader.kind() == Kind::sun) {
    light.kind = scene::LightKind::sun;
    light.direction = read_direction(reader.need("direction").one());
    return light;
  }
  light.at = read_point(reader.need("at").one());
  if (const auto falloff = reader.find("falloff")) light.falloff = read_positive(falloff->one());
  if (reader.kind() == Kind::spot) {
    light.kind = scene::LightKind::spot;
    read_cone(reader, light);
  }
  return light;
}

}  // namespace lancer::lang
