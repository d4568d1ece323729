#include "tracer/brightness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/light.hpp"
#include "tracer/pattern.hpp"

namespace lancer::tracer {
namespace {

constexpr std::size_t k_deepest = 256;  // that has a bound of its own

Color larger(Color a, Color b) { return {std::max(a.r, b.r), std::max(a.g, b.g), std::max(a.b, b.b)}; }

double distance_to_box(Vec3 lo, Vec3 hi, Vec3 p) {
  Vec3 outside;
  double inside = k_infinity;
  for (int axis = 0; axis < 3; ++axis) {
    outside[axis] = std::max({lo[axis] - p[axis], 0.0, p[axis] - hi[axis]});
    inside = std::min({inside, std::fabs(p[axis] - lo[axis]), std::fabs(hi[axis] - p[axis])});
  }
  return max_abs(outside) > 0 ? length(outside) : inside;
}

/// To the facet's bounds.
double distance_to_corners(const Vec3& a, const Vec3& b, const Vec3& c, Vec3 p) {
  Vec3 outside;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = std::minmax({a[axis], b[axis], c[axis]});
    outside[axis] = std::max({lo - p[axis], 0.0, p[axis] - hi});
  }
  return length(outside);
}

double distance_to_mesh(const scene::Mesh& mesh, Vec3 p) {
  double least = k_infinity;
  for (const auto& [a, b, c] : mesh.faces) {
    least = std::min(least, distance_to_corners(mesh.points[a], mesh.points[b], mesh.points[c], p));
  }
  return least;
}

/// A length of 1 in the map's source is no shorter than this in its image: no less than the least singular
/// value, which is 1 / the norm of the inverse M; its square is an eigenvalue of M M^T, and so no more than
/// the largest sum of a row there (Gershgorin 1931). Exact for maps that keep angles.
double shrinking(const Transform& transform) {
  const auto& rows = transform.to_object.rows;
  double most = 0;
  for (const Vec3 row : rows)
    most = std::max(
        most, std::fabs(dot(row, rows[0])) + std::fabs(dot(row, rows[1])) + std::fabs(dot(row, rows[2])));
  return 1 / std::sqrt(most);
}

/// At most the distance of a point of the shape's own space from its surface.
double own_distance(const scene::Scene& scene, const scene::Shape& shape, Vec3 p) {
  switch (shape.kind) {
    case scene::ShapeKind::sphere: {
      const scene::Sphere& s = scene.spheres[shape.record];
      return std::fabs(length(p - s.center) - s.radius);
    }
    case scene::ShapeKind::plane: {
      const scene::Plane& s = scene.planes[shape.record];
      return std::fabs(dot(p - s.point, normalize(s.normal)) - s.offset);
    }
    case scene::ShapeKind::box: {
      const scene::Box& s = scene.boxes[shape.record];
      const Transform& frame = scene.transforms[s.frame];
      return distance_to_box(s.lo, s.hi, frame.to_object.point(p)) * shrinking(frame);
    }
    case scene::ShapeKind::facet: {
      const scene::Facet& s = scene.facets[shape.record];
      return distance_to_corners(s.a, s.b, s.c, p);
    }
    case scene::ShapeKind::mesh: return distance_to_mesh(scene.meshes[shape.record], p);
  }
  return 0;
}

/// At most the distance of the light from the shape.
double least_distance(const scene::Scene& scene, const scene::Shape& shape, const scene::Light& light) {
  const Transform& transform = scene.transforms[shape.transform];
  // What rounding may have taken from the distance.
  const double rounding = 1e-12 * (max_abs(light.at) + max_abs(transform.to_world.translation));
  const double own = own_distance(scene, shape, transform.to_object.point(light.at));
  return std::max(0.0, own * shrinking(transform) * (1 - 1e-12) - rounding);
}

/// What a surface of a material can send back: of its own, and how much of what comes to it.
struct Most {
  Color own, onward;
  bool worn = false;
};

/// All lights at full strength, but those that fade with the distance.
Color steady_light(const scene::Scene& scene) {
  Color sum;
  for (const scene::Light& light : scene.lights) {
    if (!fades(light)) sum += light.color;
  }
  return sum;
}

/// Of each material, over all the shapes that wear it.
class Gatherer {
 public:
  explicit Gatherer(const scene::Scene& scene)
      : scene_(scene), steady_(steady_light(scene)), most_(scene.materials.size()) {
    for (scene::Index i = 0; i < scene.lights.size(); ++i) {
      const scene::Light& light = scene.lights[i];
      if (fades(light) && !is_black(light.color)) fading_.push_back(i);
    }
  }

  std::vector<Most> run(std::optional<NearLamp>& near_lamp) {
    for (scene::Index i = 0; i < scene_.shapes.size() && !near_lamp; ++i) add(i, near_lamp);
    return std::move(most_);
  }

 private:
  void add(scene::Index index, std::optional<NearLamp>& near_lamp) {
    const scene::Shape& shape = scene_.shapes[index];
    const scene::Material& m = scene_.materials[shape.material];
    Most& most = most_[shape.material];
    if (most.worn && fading_.empty()) return;
    const Color bracket = largest(scene_, m.diffuse) + largest(scene_, m.specular);
    Color light = steady_;
    for (const scene::Index i : fading_) {
      if (is_black(bracket)) break;
      const scene::Light& lamp = scene_.lights[i];
      const double ratio = lamp.falloff / least_distance(scene_, shape, lamp);
      light += lamp.color * (ratio * ratio);
      if (!std::isfinite(ratio * ratio)) near_lamp = NearLamp{i, index};
    }
    most.own = larger(most.own, largest(scene_, m.ambient) * scene_.settings.ambient + bracket * light);
    most.onward = largest(scene_, m.reflection) + largest(scene_, m.transmission);
    most.worn = true;
  }

  const scene::Scene& scene_;
  Color steady_;
  std::vector<scene::Index> fading_;
  std::vector<Most> most_;
};

}  // namespace

Color largest(const scene::Scene& scene, const scene::Texture& texture) {
  if (texture.pattern == scene::k_none) return texture.color;
  const scene::Pattern& pattern = scene.patterns[texture.pattern];
  return larger(pattern.a, pattern.b);
}

Brightness::Brightness(const scene::Scene& scene) {
  const std::vector<Most> materials = Gatherer(scene).run(near_lamp_);
  beyond_ = grey(k_infinity);
  if (near_lamp_) return;
  const std::size_t depths =
      std::min<std::size_t>(static_cast<std::size_t>(scene.settings.depth) + 1, k_deepest);
  for (std::size_t depth = 0; depth < depths; ++depth) {
    Color most = scene.settings.background;
    for (const Most& m : materials) {
      if (m.worn) most = larger(most, depth == 0 ? m.own : m.own + m.onward * bound_.back());
    }
    bound_.push_back(most);
    // What no longer grows never will.
    if (depth > 0 && most == bound_[depth - 1]) {
      beyond_ = most;
      break;
    }
  }
}

Color Brightness::bound(int depth) const {
  return static_cast<std::size_t>(depth) < bound_.size() ? bound_[static_cast<std::size_t>(depth)] : beyond_;
}

double tolerance(double shown) {
  // The slope is 12.92 up to 0.0031308, then 1.055 / 2.4 shown^(-1.4 / 2.4); the root below stays under the
  // inverse of both: 0.0548 <= 1 / 12.92, at the joint 0.0773, at 1 0.97 <= 2.27.
  return std::sqrt(0.003 + 0.945 * std::min(shown, 1.0));
}

}  // namespace lancer::tracer
