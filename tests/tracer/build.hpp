#pragma once
// Scenes for tests, one call a thing.

#include "scene/scene.hpp"
#include "tracer/intersect.hpp"
#include "tracer/light.hpp"
#include "tracer/plan.hpp"
#include "tracer/radiance.hpp"
#include "tracer/render.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer::test {

using scene::Index;
using scene::Material;
using scene::Scene;
using scene::ShapeKind;

inline Index add_transform(Scene& s, const Affine& map) {
  s.transforms.push_back({map, *inverse(map)});
  return static_cast<Index>(s.transforms.size() - 1);
}

template <class T>
Index add_shape(Scene& s, ShapeKind kind, std::vector<T>& records, const T& record, const Material& material,
                const Affine& map = {}) {
  records.push_back(record);
  s.materials.push_back(material);
  scene::Shape shape;
  shape.kind = kind;
  shape.record = static_cast<Index>(records.size() - 1);
  shape.material = static_cast<Index>(s.materials.size() - 1);
  shape.transform = map == Affine{} ? 0 : add_transform(s, map);
  s.shapes.push_back(shape);
  return static_cast<Index>(s.shapes.size() - 1);
}

inline Index add_sphere(Scene& s, Vec3 c, double r, const Material& m = {}, const Affine& map = {}) {
  return add_shape(s, ShapeKind::sphere, s.spheres, {c, r}, m, map);
}
inline Index add_plane(Scene& s, Vec3 point, Vec3 normal, const Material& m = {}, const Affine& map = {}) {
  return add_shape(s, ShapeKind::plane, s.planes, {point, normal, 0}, m, map);
}
inline Index add_box(Scene& s, Vec3 lo, Vec3 hi, const Material& m = {}, const Affine& map = {}) {
  return add_shape(s, ShapeKind::box, s.boxes, {lo, hi, 0}, m, map);
}
inline Index add_facet(Scene& s, Vec3 a, Vec3 b, Vec3 c, const Material& m = {}, const Affine& map = {}) {
  return add_shape(s, ShapeKind::facet, s.facets, {a, b, c, scene::k_none}, m, map);
}
inline Index add_mesh(Scene& s, const scene::Mesh& mesh, const Material& m = {}, const Affine& map = {}) {
  return add_shape(s, ShapeKind::mesh, s.meshes, mesh, m, map);
}

/// The cube [-1, 1]^3, wound outwards.
inline scene::Mesh cube_mesh(bool solid) {
  scene::Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh.solid = solid;
  return mesh;
}

/// All coefficients 0: a surface that only shows what a test sets.
inline Material black() {
  Material m;
  m.ambient.color = m.diffuse.color = {};
  return m;
}
inline Material glowing(double level) {
  Material m = black();
  m.ambient.color = grey(level);
  return m;
}
inline Material mirror(double share) {
  Material m = black();
  m.reflection.color = grey(share);
  return m;
}
inline Material clear(double share, double ior) {
  Material m = black();
  m.transmission.color = grey(share);
  m.ior = ior;
  return m;
}
inline Material matt(double level) {
  Material m = black();
  m.diffuse.color = grey(level);
  return m;
}

inline scene::Light point_light(Vec3 at, double level = 1) {
  scene::Light light;
  light.at = at;
  light.color = grey(level);
  return light;
}
inline scene::Light sun(Vec3 direction, double level = 1) {
  scene::Light light;
  light.kind = scene::LightKind::sun;
  light.direction = direction;
  light.color = grey(level);
  return light;
}

/// How a light looks from a point.
struct Incoming {
  Vec3 towards;
  double distance = 0;
  Color intensity;
};
inline Incoming incoming(const scene::Light& light, Vec3 p) {
  const Bearing from = bearing(light, p);
  return {from.towards, from.distance, intensity(light, from)};
}

/// A bit of everything around the origin, then moved: glass, a mirror, a turned box, a squeezed sphere,
/// facets, and a floor with the first pattern.
inline Scene still_life(const Affine& move = {}) {
  Scene s;
  s.settings.background = {0.1, 0.2, 0.3};
  Material glass = clear(0.9, 1.5);
  glass.fresnel = true;
  Material floor = matt(0.8);
  floor.diffuse.pattern = 0;
  s.patterns.emplace_back();
  s.patterns[0].a = grey(1);
  s.patterns[0].b = grey(0.2);
  add_plane(s, {0, -1, 0}, {0, 1, 0}, floor, move);
  add_sphere(s, {0, 0, 0}, 1, glass, move);
  add_box(s, {1, -1, -2}, {2, 0, -1}, mirror(0.8), then(rotation({0, 20, 0}), move));
  add_sphere(s, {}, 0.5, matt(0.6), then(then(scaling({1, 2, 1}), translation({-1.5, 0, -1})), move));
  add_mesh(s, cube_mesh(true), clear(0.7, 1.3),
           then(then(scaling({0.3, 0.3, 0.3}), translation({0.5, -0.7, 1.3})), move));
  const Place lamp = move.place({{4, 6, 5}, {}});
  s.lights.push_back(point_light(lamp.at));
  s.lights[0].at_rest = lamp.rest;
  return s;
}

/// A view of n x n pixels.
inline scene::View view(Vec3 eye, Vec3 look, int n = 33, double fov = 50) {
  scene::View v;
  v.eye = eye;
  v.look = look;
  v.fov = fov;
  v.columns = v.rows = n;
  return v;
}

/// What is seen from `eye` along `direction`, with full depth and an eye inside solids as in a picture.
inline Color seen(const Scene& s, Vec3 eye, Vec3 direction) {
  scene::View v = view(eye, direction, 1);
  if (std::fabs(direction.y) > 0.999 * length(direction)) v.up = {0, 0, 1};
  Options options;
  options.samples = 1;
  options.threads = 1;
  const Rendered out = render(s, v, options);
  const auto p = out.image.pixel(0, 0);
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

inline Rendered picture(const Scene& s, const scene::View& v, int samples = 1, int threads = 1) {
  Options options;
  options.samples = samples;
  options.threads = threads;
  return render(s, v, options);
}

/// The picture's values, r, g, b of each pixel.
inline std::vector<float> values(const Scene& s, const scene::View& v, int samples = 1) {
  return picture(s, v, samples).image.data();
}

/// Numbers in [0, 1) from a fixed sequence.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  double operator()() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double between(double a, double b) { return a + (b - a) * (*this)(); }
  Vec3 in_cube(double half) {
    const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
    return {x, y, z};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = in_cube(1);
      const double size = dot(v, v);
      if (size > 0.01 && size <= 1) return normalize(v);
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace lancer::tracer::test
