#include "tracer/camera.hpp"

#include "base/math.hpp"
#include "tracer/numeric.hpp"

namespace lancer::tracer {

Camera::Camera(const scene::View& view, int columns, int rows, Vec3 origin)
    : parallel_(view.projection == scene::Projection::orthographic),
      corners_(view.projection == scene::Projection::corners),
      columns_(columns),
      rows_(rows),
      eye_(Place{view.eye, view.eye_rest}.from(origin).at) {
  if (corners_) {
    const auto way = [&](Vec3 from, Vec3 rest, std::size_t corner) {
      return Place{view.corners[corner], view.corner_rests[corner]}.from(from).at - rest;
    };
    middle_ = way(view.eye, view.eye_rest, 0);
    right_ = way(view.corners[0], view.corner_rests[0], 1);
    up_ = way(view.corners[0], view.corner_rests[0], 2);
    return;
  }
  middle_ = normalize(view.look);
  const Vec3 r = normalize(accurate_cross(middle_, normalize(view.up)));
  const Vec3 u = accurate_cross(r, middle_);
  const double half_width = parallel_ ? view.width / 2 : math::tan_deg(view.fov / 2);
  right_ = r * half_width;
  up_ = u * (half_width * (rows_ / columns_));
}

CameraRay Camera::ray(double x, double y) const {
  if (corners_) return {eye_, normalize(middle_ + right_ * (x / columns_) + up_ * (y / rows_))};
  // (2i+1)/w - 1 with one rounding instead of two.
  const Vec3 offset = right_ * ((2 * x - columns_) / columns_) - up_ * ((2 * y - rows_) / rows_);
  if (parallel_) return {eye_ + offset, middle_};
  return {eye_, normalize(middle_ + offset)};
}

}  // namespace lancer::tracer
