// No length is special: scenes of any size and place look the same, and no surface shadows or mirrors itself.

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

constexpr int k_pixels = 40;

/// One of each kind of convex shape, by number, about 2 wide, at the origin.
constexpr int k_kinds = 7;
void add_kind(Scene& s, int kind, const Material& m, const Affine& map) {
  const Affine turned = then(rotation({20, 40, 10}), map);
  scene::Mesh mesh = cube_mesh(true);
  switch (kind) {
    case 0: add_sphere(s, {0, 0, 0}, 1, m, map); break;
    case 1: add_sphere(s, {0, 0, 0}, 1, m, then(scaling({1, 0.5, 0.8}), turned)); break;
    case 2: add_box(s, {-1, -1, -1}, {1, 0.5, 0.8}, m, map); break;
    case 3: add_box(s, {-1, -1, -1}, {1, 0.5, 0.8}, m, turned); break;
    case 4: add_facet(s, {-1, -1, 0}, {1, -0.5, 0.3}, {0, 1, -0.2}, m, map); break;
    case 5: add_mesh(s, mesh, m, turned); break;
    default: add_plane(s, {0, 0, 0}, {0.1, 0.2, 1}, m, map); break;
  }
}

const double k_scales[] = {1e-9, 1e-5, 1, 1e3, 1e9};
const Vec3 k_offsets[] = {{0, 0, 0}, {1e6, -0.75e6, 0.5e6}};  // in sizes

struct Placing {
  double size;
  Vec3 offset;
  Affine map() const { return then(scaling({size, size, size}), translation(offset * size)); }
  Vec3 point(Vec3 p) const { return (p + offset) * size; }
};

template <class Test>
void in_every_place(Test test) {
  for (const double size : k_scales) {
    for (const Vec3 offset : k_offsets) test(Placing{size, offset});
  }
}

scene::View look_at_origin(const Placing& place, Vec3 eye) {
  return view(place.point(eye), -eye, k_pixels, 30);
}

}  // namespace

TEST_CASE("scale: no lit convex shape shadows itself, at any size and place", "[scale]") {
  in_every_place([](const Placing& place) {
    for (int kind = 0; kind < k_kinds; ++kind) {
      Scene s;
      add_kind(s, kind, matt(1), place.map());
      s.lights.push_back(point_light(place.point({2, 3, 5})));
      s.lights.push_back(sun({-1, -0.1, -0.01}));
      s.settings.shadows = scene::Shadows::opaque;
      const Rendered shadowed = picture(s, look_at_origin(place, {1, 1.5, 5}));
      s.settings.shadows = scene::Shadows::off;
      const Rendered plain = picture(s, look_at_origin(place, {1, 1.5, 5}));
      CHECK(shadowed.image.data() == plain.image.data());
      CHECK(plain.stats.primary_rays > 0);
    }
  });
}

TEST_CASE("scale: no convex mirror shows itself, at any size and place", "[scale]") {
  in_every_place([](const Placing& place) {
    for (int kind = 0; kind < k_kinds; ++kind) {
      Scene s;
      s.settings.background = grey(1);
      add_kind(s, kind, mirror(0.5), place.map());
      int hits = 0;
      for (const float value : values(s, look_at_origin(place, {1, 1.5, 5}))) {
        REQUIRE((value == 1 || value == 0.5F));
        hits += value == 0.5F ? 1 : 0;
      }
      CHECK(hits > 50);
    }
  });
}

TEST_CASE("scale: every way into a clear solid has its way out", "[scale]") {
  in_every_place([](const Placing& place) {
    for (const int kind : {0, 1, 2, 3, 5}) {
      Scene s;
      s.settings.background = grey(1);
      s.settings.depth = 2;
      add_kind(s, kind, clear(0.5, 1), place.map());
      int hits = 0;
      for (const float value : values(s, look_at_origin(place, {1, 1.5, 5}))) {
        REQUIRE((value == 1 || value == 0.25F));
        hits += value == 0.25F ? 1 : 0;
      }
      CHECK(hits > 50);
    }
  });
}

TEST_CASE("scale: a glass ball bends light alike at any size and place", "[scale]") {
  std::vector<float> expected;
  in_every_place([&](const Placing& place) {
    Scene s;
    s.settings.ambient = grey(1);
    Material ruler = glowing(1);
    ruler.ambient.pattern = 0;
    scene::Pattern p;
    p.kind = scene::Pattern::Kind::gradient;
    p.b = {1, 0.5, 0.25};
    p.from = {-5, -4, 0};
    p.to = {6, 3, 0};
    s.patterns.push_back(p);
    add_sphere(s, {0.01, 0.02, 0}, 1, clear(1, 1.5), place.map());
    add_plane(s, {0, 0, -3}, {0.3, 0.2, 1}, ruler, place.map());
    const Rendered out = picture(s, view(place.point({0, 0, 5}), {0, 0, -1}, k_pixels, 30));
    if (expected.empty()) expected = out.image.data();
    int off = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
      off += std::fabs(out.image.data()[i] - expected[i]) > 1e-5F;
    CHECK(off <= 6);  // the silhouette may fall on the other side of a pixel's centre
  });
}

TEST_CASE("scale: lengths times a power of two change no bit of the picture", "[scale]") {
  const auto scene_at = [](double k) {
    Scene s;
    s.settings.background = grey(0.2);
    Material glass = clear(0.9, 1.5);
    glass.fresnel = true;
    Material floor = matt(0.8);
    floor.diffuse.pattern = 0;
    s.patterns.emplace_back();
    s.patterns[0].a = grey(1);
    s.patterns[0].size = 0.7 * k;
    add_plane(s, Vec3{0, -1, 0} * k, {0.1, 1, 0}, floor);
    add_sphere(s, Vec3{0, 0.1, 0} * k, 0.9 * k, glass);
    add_box(s, Vec3{1, -0.9, -2} * k, Vec3{2, 0.3, -1.1} * k, mirror(0.8), rotation({0, 20, 0}));
    add_box(s, Vec3{-3, -0.9, -2} * k, Vec3{-2.1, 0.3, -1.1} * k, mirror(0.8));
    add_sphere(s, {}, 0.5 * k, matt(0.6), then(scaling({1, 2, 1}), translation(Vec3{-1.5, 0, -1} * k)));
    scene::Mesh mesh = cube_mesh(true);
    for (Vec3& p : mesh.points) p = (p * 0.3 + Vec3{0.5, -0.7, 1.3}) * k;
    add_mesh(s, mesh, clear(0.7, 1.3));
    s.lights.push_back(point_light(Vec3{4, 6, 5} * k));
    s.lights[0].falloff = 7 * k;
    s.lights.push_back(point_light(Vec3{-4, 6, 5} * k));
    s.lights[1].kind = scene::LightKind::spot;
    s.lights[1].direction = Vec3{4, -6, -5} * k;
    s.lights[1].softness = 0.9;
    return s;
  };
  const auto view_at = [](double k) { return view(Vec3{0, 0.8, 5} * k, Vec3{0, -0.15, -1} * k, k_pixels); };
  const Rendered plain = picture(scene_at(1), view_at(1), 2);
  for (const int exponent : {-300, -100, -40, -5, -1, 1, 10, 40, 60, 200}) {
    const double k = std::ldexp(1.0, exponent);
    INFO("2^" << exponent);
    CHECK(picture(scene_at(k), view_at(k), 2).image.data() == plain.image.data());
  }
}

TEST_CASE("scale: a ball on a floor is lit and shadowed alike at any size and place", "[scale]") {
  std::vector<float> expected;
  in_every_place([&](const Placing& place) {
    Scene s;
    s.settings.ambient = {};
    add_plane(s, {0, 0, 0}, {0, 1, 0}, matt(0.9), place.map());
    add_sphere(s, {0, 1, 0}, 1, matt(0.9), place.map());
    add_box(s, {1.25, 0, -0.5}, {2.25, 1, 0.5}, matt(0.9), place.map());
    add_facet(s, {-3, 0, -1}, {-1, 0, -2}, {-2, 2.5, -1.5}, matt(0.9), place.map());
    s.lights.push_back(point_light(place.point({-4, 6, 5})));
    const Rendered out = picture(s, view(place.point({0, 1.5, 6}), {0, 0, -1}, 64, 37));
    if (expected.empty()) expected = out.image.data();
    int off = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
      off += std::fabs(out.image.data()[i] - expected[i]) > 1e-4F;
    CHECK(off <= 6);  // an outline or a shadow's edge may fall on the other side of a pixel's centre
  });
}

TEST_CASE("scale: a sphere stays one, and no other becomes one, near the ends of the range of numbers",
          "[scale]") {
  for (const double size : {1e-290, 1e-170, 1.0, 1e170, 1e290}) {
    Scene s;
    add_sphere(s, {}, 1, {}, then(rotation({0, 90, 0}), scaling({size, size, size})));
    add_sphere(s, {}, 1, {}, scaling({size, 2 * size, size}));
    const World world = prepare(s);
    REQUIRE(world.spheres.size() == 1);
    CHECK(world.spheres[0].radius == size);
    CHECK(world.ellipsoids.size() == 1);
  }
}
