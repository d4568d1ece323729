#include "base/math.hpp"
#include "catch.hpp"
#include "scene/scene.hpp"

using namespace lancer;
using namespace lancer::scene;

namespace {

Index add(Scene& s, ShapeKind kind, std::size_t record, Index transform = 0) {
  Shape shape;
  shape.kind = kind;
  shape.record = static_cast<Index>(record);
  shape.transform = transform;
  s.shapes.push_back(shape);
  return static_cast<Index>(s.shapes.size() - 1);
}

void add_sphere(Scene& s, Vec3 c, double r, Index transform = 0) {
  s.spheres.push_back({c, r});
  add(s, ShapeKind::sphere, s.spheres.size() - 1, transform);
}

/// The ball that the view frames: its distance from the eye is 1.05 radii over the sine of half the vertical
/// opening.
double framed_radius(const View& view, Vec3 center) {
  const double slope = math::tan_deg(25) * 0.75;
  const double sine = slope / std::sqrt(1 + slope * slope);
  return length(view.eye - center) * sine / 1.05;
}

}  // namespace

TEST_CASE("automatic view: a sphere fills the height, seen from the front, a little above and right",
          "[scene]") {
  Scene s;
  add_sphere(s, {1, 2, 3}, 4);
  const View view = automatic_view(s);
  CHECK(view.projection == Projection::perspective);
  CHECK(view.columns == 640);
  CHECK(view.rows == 480);
  CHECK(view.fov == 50);
  CHECK(framed_radius(view, {1, 2, 3}) == Approx(4));
  const Vec3 from = view.eye - Vec3{1, 2, 3};
  CHECK(from.z > from.x);
  CHECK(from.x > 0);
  CHECK(from.y > 0);
  // It looks at the centre.
  CHECK(length(normalize(view.look) + normalize(from)) < 1e-15);
}

TEST_CASE("automatic view: transforms count, planes do not while there is something else", "[scene]") {
  Scene s;
  const Affine map = then(scaling({2, 2, -2}), translation({10, 0, 0}));
  s.transforms.push_back({map, *inverse(map)});
  add_sphere(s, {0, 0, 0}, 1, 1);
  s.planes.push_back({{500, 0, 0}, {0, 1, 0}, 0});
  add(s, ShapeKind::plane, 0);
  CHECK(framed_radius(automatic_view(s), {10, 0, 0}) == Approx(2));
}

TEST_CASE("automatic view: boxes, facets and meshes are framed by their corners", "[scene]") {
  Scene s;
  s.boxes.push_back({{-1, -2, -2}, {1, 2, 2}, 0});
  add(s, ShapeKind::box, 0);
  CHECK(framed_radius(automatic_view(s), {0, 0, 0}) == Approx(3));  // sqrt(1 + 4 + 4)
  Scene f;
  f.facets.push_back({{0, 0, 0}, {2, 0, 0}, {0, 4, 4}, k_none});
  add(f, ShapeKind::facet, 0);
  CHECK(framed_radius(automatic_view(f), {1, 2, 2}) == Approx(3));
  Scene m;
  m.meshes.push_back({{{0, 0, 0}, {2, 0, 0}, {0, 4, 4}}, {{0, 1, 2}}, {}, false});
  add(m, ShapeKind::mesh, 0);
  CHECK(framed_radius(automatic_view(m), {1, 2, 2}) == Approx(3));
}

TEST_CASE("automatic view: two spheres are framed together", "[scene]") {
  Scene s;
  add_sphere(s, {-5, 0, 0}, 1);
  add_sphere(s, {5, 0, 0}, 1);
  CHECK(framed_radius(automatic_view(s), {0, 0, 0}) == Approx(6));
}

TEST_CASE("automatic view: planes alone are seen at their points, an empty scene at the origin", "[scene]") {
  Scene s;
  CHECK(framed_radius(automatic_view(s), {0, 0, 0}) == Approx(1));
  s.planes.push_back({{0, 0, 0}, {0, 2, 0}, 7});
  add(s, ShapeKind::plane, 0);
  CHECK(framed_radius(automatic_view(s), {0, 7, 0}) == Approx(1));
}

TEST_CASE("automatic view: tiny and huge scenes are framed as well", "[scene]") {
  for (const double size : {1e-9, 1e9}) {
    Scene s;
    add_sphere(s, {0, 0, 0}, size);
    CHECK(framed_radius(automatic_view(s), {0, 0, 0}) == Approx(size));
  }
}
