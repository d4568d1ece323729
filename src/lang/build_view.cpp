// Views: three ways to say where a picture is seen from.

#include <fmt/format.h>

#include "base/number.hpp"
#include "lang/build_parts.hpp"
#include "lang/geometry_checks.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

constexpr int k_largest_size = 65536;
constexpr Vec3 k_y{0, 1, 0};
constexpr Vec3 k_z{0, 0, 1};

/// Where the view looks, with what rounding may have done to it.
UncertainVec read_look(const BlockReader& reader, Vec3 eye) {
  if (const auto look = reader.find("look")) {
    const Vec3 v = read_point(look->one());
    if (v == Vec3{}) {
      throw ScriptError(Code::bad_view, look->span(), "a view's look is not zero",
                        "write where it looks, such as <0, 0, -1>");
    }
    return written_direction(v);
  }
  const Argument target = reader.need("look_at").one();
  const Vec3 look_at = read_point(target);
  if (look_at == eye) {
    throw ScriptError(Code::bad_view, target.span, "a view does not look at its own eye",
                      fmt::format("`eye` and `look_at` are both {}", to_text(eye)));
  }
  if (!is_finite(look_at - eye)) {
    throw ScriptError(Code::not_finite, target.span,
                      "from `eye` to `look_at` is beyond the range of numbers");
  }
  const UncertainVec half = direction_between(eye, look_at);
  return {look_at - eye, half.error * 2};
}

Vec3 read_up(const BlockReader& reader, const UncertainVec& look) {
  const auto slot = reader.find("up");
  if (!slot) return are_parallel(look, {k_y, {}}) ? k_z : k_y;
  const Vec3 up = read_direction(slot->one());
  if (are_parallel(look, written_direction(up))) {
    throw ScriptError(Code::bad_view, slot->span(), "a view does not look along its up",
                      fmt::format("it looks along {}; any other direction will do as `up`, or leave it out",
                                  to_text(look.value)));
  }
  return up;
}

int read_size(const Argument& argument) { return read_whole(argument, 1, k_largest_size); }

void read_screen(const Slot& corners, scene::View& view) {
  view.projection = scene::Projection::corners;
  view.corners = {read_point(corners[0]), read_point(corners[1]), read_point(corners[2])};
  if (are_on_a_line(view.corners[0], view.corners[1], view.corners[2])) {
    throw ScriptError(Code::degenerate, corners.span(), "the corners of a view's screen lie on a line",
                      "they are the top left, the top right and the bottom left one");
  }
}

}  // namespace

scene::View build_view(const BlockReader& reader) {
  scene::View view;
  view.eye = read_point(reader.need("eye").one());
  if (const auto size = reader.find("size")) {
    view.columns = read_size((*size)[0]);
    view.rows = read_size((*size)[1]);
  }
  if (const auto corners = reader.find("corners")) {
    read_screen(*corners, view);
    return view;
  }
  const UncertainVec look = read_look(reader, view.eye);
  view.look = look.value;
  view.up = read_up(reader, look);
  if (const auto width = reader.find("width")) {
    view.projection = scene::Projection::orthographic;
    view.width = read_positive(width->one());
  }
  if (const auto fov = reader.find("fov")) view.fov = read_opening(fov->one());
  return view;
}

}  // namespace lancer::lang
