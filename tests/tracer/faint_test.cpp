// What is too faint to show may be left out: the pixel stays within an eighth of the error asked for.

#include "tracer/faint.hpp"

#include <cmath>

#include "base/math.hpp"
#include "catch.hpp"
#include "random_scene.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Rendered with_error(const Scene& s, const scene::View& v, double error) {
  Options options;
  options.samples = 4;
  options.threads = 1;
  options.error = error;
  return render(s, v, options);
}

double display(float linear, double exposure) {
  return math::linear_to_srgb(std::fmin(1, static_cast<double>(linear) * exposure));
}

/// The largest difference of two pictures, as shown.
double difference(const Scene& s, const Rendered& a, const Rendered& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.image.data().size(); ++i) {
    const double exposure = s.settings.exposure;
    most = std::fmax(most,
                     std::fabs(display(a.image.data()[i], exposure) - display(b.image.data()[i], exposure)));
  }
  return most;
}

std::uint64_t onward_rays(const Rendered& r) { return r.stats.reflected_rays + r.stats.refracted_rays; }

/// Balls of glass in a row: every surface sends light two ways.
Scene glass_row(int depth) {
  Scene s;
  s.settings.background = {0.5, 0.7, 0.9};
  s.settings.depth = depth;
  Material glass = clear(0.96, 1.5);
  glass.fresnel = true;
  for (int i = 0; i < 4; ++i) add_sphere(s, {0.3 * i, 0.1 * i, -2.5 * i}, 1, glass);
  Material floor = matt(0.8);
  floor.ambient.color = grey(0.8);
  add_plane(s, {0, -2, 0}, {0, 1, 0}, floor);
  s.lights.push_back(point_light({4, 6, 5}, 0.8));
  return s;
}

}  // namespace

TEST_CASE("faint: the brightest ray comes first, and what is left is known", "[faint]") {
  PendingRays rays;
  CHECK(rays.fit({}));
  for (const int depth : {3, 1, 4, 2}) {
    Pending p;
    p.depth = depth;
    rays.push(p, grey(depth));
  }
  CHECK_FALSE(rays.fit(grey(9.9)));
  CHECK(rays.fit(grey(10)));
  CHECK_FALSE(rays.fit({10, 9, 10}));
  CHECK(rays.pop().depth == 4);
  CHECK(rays.fit(grey(6)));
  CHECK(rays.pop().depth == 3);
  rays.push({}, grey(0.5));
  CHECK(rays.pop().depth == 2);
  CHECK(rays.size() == 2);
  CHECK(rays.fit(grey(1.5)));
}

TEST_CASE("faint: rays in glass grow with the depth no more, and the picture stays", "[faint]") {
  const scene::View v = view({0, 0.5, 5}, {0, -0.1, -1}, 20);
  const auto sum = GENERATE(scene::Sum::linear, scene::Sum::log);
  std::uint64_t before = 0;
  for (const int depth : {6, 9, 12}) {
    Scene s = glass_row(depth);
    s.settings.sum = sum;
    const Rendered all = with_error(s, v, 0), some = with_error(s, v, 0.01);
    CHECK(difference(s, all, some) <= 0.01 / 8);
    CHECK(some.stats.rays_faint > 0);
    CHECK(onward_rays(some) < onward_rays(all));
    if (before > 0) CHECK(static_cast<double>(onward_rays(some)) < 2 * static_cast<double>(before));
    before = onward_rays(some);
  }
}

TEST_CASE("faint: what may go missing shrinks with what went", "[faint]") {
  Allowance a(grey(16));
  CHECK_FALSE(a.takes({0, 1.1, 0}));
  CHECK(a.takes({1, 0.5, 0}));
  CHECK(a.left() == Color{15, 15.5, 16});
  CHECK_FALSE(a.takes({1, 0, 0}));
}

TEST_CASE("faint: random scenes stay within an eighth of any error asked for", "[faint]") {
  std::uint64_t spared = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Scene s = random_scene(seed);
    const scene::View v = random_view(seed, 10, 8);
    const Rendered all = with_error(s, v, 0);
    for (const double error : {0.002, 0.02, 0.2}) {
      const Rendered some = with_error(s, v, error);
      INFO("seed " << seed << ", error " << error);
      REQUIRE(difference(s, all, some) <= error / 8);
      spared += some.stats.rays_faint + some.stats.lights_faint;
    }
  }
  CHECK(spared > 1000);
}

TEST_CASE("faint: a thousand lamps out of reach cost no shadow rays", "[faint]") {
  Scene s;
  s.settings.ambient = grey(0.2);
  add_sphere(s, {}, 1, Material{});
  s.lights.push_back(point_light({3, 4, 5}, 0.9));
  const scene::View v = view({0, 0, 5}, {0, 0, -1}, 16);
  const std::uint64_t before = with_error(s, v, 0.01).stats.shadow_rays;
  for (int i = 0; i < 1000; ++i) {
    s.lights.push_back(point_light({1000.0 + i, 500, 800}, 0.5));
    s.lights.back().falloff = 0.05;
  }
  const Rendered all = with_error(s, v, 0), some = with_error(s, v, 0.01);
  CHECK(all.stats.shadow_rays > 500 * before);
  CHECK(some.stats.shadow_rays == before);
  CHECK(some.stats.lights_faint > 500 * before);
  CHECK(difference(s, all, some) <= 0.01 / 8);
}

TEST_CASE("faint: lamps that show only near them are asked, and cost no shadow rays elsewhere", "[faint]") {
  Scene s;
  s.settings.ambient = grey(0.2);
  add_plane(s, {0, 0, 0}, {0, 1, 0}, Material{});
  for (int i = 0; i < 40; ++i) {
    s.lights.push_back(point_light({3.0 * i, 0.3, 0}, 0.5));
    s.lights.back().falloff = 0.02;
  }
  const scene::View v = view({0, 2, 5}, {0, -0.4, -1}, 16);
  const Rendered all = with_error(s, v, 0), some = with_error(s, v, 0.05);
  CHECK(some.stats.shadow_rays < all.stats.shadow_rays / 5);
  CHECK(some.stats.lights_faint > all.stats.shadow_rays / 2);
  CHECK(difference(s, all, some) <= 0.05 / 8);
}

TEST_CASE("faint: what many surfaces in one another lose to faint lights is counted together", "[faint]") {
  Scene s;
  s.settings.ambient = {};
  s.settings.depth = 40;
  Material m = mirror(0.95);
  m.diffuse.color = grey(0.5);
  add_plane(s, {0, 0, -2}, {0, 0, 1}, m);
  add_plane(s, {0, 0, 2}, {0, 0, -1}, m);
  s.settings.shadows = scene::Shadows::opaque;
  // Each adds at most half of 3e-4; an eighth of 0.2 in the dark is 1.4e-3.
  for (int i = 0; i < 30; ++i) s.lights.push_back(point_light({0.2 * i - 3, 1, 0}, 3e-4));
  for (const auto sum : {scene::Sum::linear, scene::Sum::log}) {
    s.settings.sum = sum;
    const scene::View v = view({0, 0, 1}, {0.1, 0.02, -1}, 8);
    const Rendered all = with_error(s, v, 0), some = with_error(s, v, 0.2);
    CHECK(some.stats.lights_faint > 0);
    CHECK(difference(s, all, some) <= 0.2 / 8);
  }
}
