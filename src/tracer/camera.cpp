#include "tracer/camera.hpp"

#include "base/math.hpp"
#include "tracer/numeric.hpp"

namespace lancer::tracer {

Camera::Camera(const scene::View& view, int columns, int rows, Vec3 origin) {
  aim_.parallel = view.projection == scene::Projection::orthographic;
  aim_.corners = view.projection == scene::Projection::corners;
  aim_.columns = columns;
  aim_.rows = rows;
  aim_.eye = Place{view.eye, view.eye_rest}.from(origin).at;
  if (aim_.corners) {
    const auto way = [&](Vec3 from, Vec3 rest, std::size_t corner) {
      return Place{view.corners[corner], view.corner_rests[corner]}.from(from).at - rest;
    };
    aim_.middle = way(view.eye, view.eye_rest, 0);
    aim_.right = way(view.corners[0], view.corner_rests[0], 1);
    aim_.up = way(view.corners[0], view.corner_rests[0], 2);
    return;
  }
  aim_.middle = normalize(view.look);
  const Vec3 r = normalize(accurate_cross(aim_.middle, normalize(view.up)));
  const Vec3 u = accurate_cross(r, aim_.middle);
  const double half_width = aim_.parallel ? view.width / 2 : math::tan_deg(view.fov / 2);
  aim_.right = r * half_width;
  aim_.up = u * (half_width * (aim_.rows / aim_.columns));
}

CameraRay Camera::ray(double x, double y) const {
  const auto& [parallel, corners, columns, rows, eye, middle, right, up] = aim_;
  if (corners) return {eye, normalize(middle + right * (x / columns) + up * (y / rows))};
  // (2i+1)/w - 1 with one rounding instead of two.
  const Vec3 offset = right * ((2 * x - columns) / columns) - up * ((2 * y - rows) / rows);
  if (parallel) return {eye + offset, middle};
  return {eye, normalize(middle + offset)};
}

}  // namespace lancer::tracer
