#include "tracer/radiance.hpp"

#include <chrono>
#include <thread>

#include "base/math.hpp"
#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// Between two facing mirrors that keep `share` and glow a little.
Scene mirror_hall(double share, int depth) {
  Scene s;
  s.settings.ambient = grey(1);
  s.settings.depth = depth;
  Material m = mirror(share);
  m.ambient.color = grey(1 - share);
  add_plane(s, {0, 0, -1}, {0, 0, 1}, m);
  add_plane(s, {0, 0, 1}, {0, 0, -1}, m);
  return s;
}

}  // namespace

TEST_CASE("radiance: a hall of mirrors sums its geometric series", "[radiance]") {
  // (1-k)(1 + k + ... + k^n) = 1 - k^(n+1).
  for (const int depth : {0, 1, 5, 60, 1000}) {
    const double k = 0.97;
    CHECK(seen(mirror_hall(k, depth), {0, 0, 0}, {0.01, 0, 1}).r ==
          Approx(1 - math::pow(k, depth + 1)).epsilon(1e-6));
  }
}

TEST_CASE("radiance: depths of a hundred thousand neither crash nor change the sum", "[radiance]") {
  Scene s = mirror_hall(0.9999, 100000);
  CHECK(seen(s, {0, 0, 0}, {1e-9, 0, 1}).r == Approx(1 - math::pow(0.9999, 100001)).epsilon(1e-6));
  // Log: c = a + k c' - a k c', from the innermost, c = a, out.
  s.settings.sum = scene::Sum::log;
  double c = 0.0001;
  for (int i = 0; i < 100000; ++i) c = 0.0001 + 0.9999 * c - 0.0001 * 0.9999 * c;
  CHECK(seen(s, {0, 0, 0}, {1e-9, 0, 1}).r == Approx(c).epsilon(1e-6));
}

TEST_CASE("radiance: a white furnace seen through glass that loses nothing stays white", "[radiance]") {
  // Background 1, Fresnel shares add to 1; what depth leaves out shrinks with it.
  Material glass = clear(1, 1.5);
  glass.fresnel = true;
  Scene s;
  s.settings.background = grey(1);
  s.settings.depth = 60;
  add_sphere(s, {0, 0, 0}, 1, glass);
  const Rendered out = picture(s, view({0, 0, 4}, {0, 0, -1}, 15, 30));
  for (const float value : out.image.data()) CHECK(value == Approx(1).epsilon(1e-3));
}

TEST_CASE("radiance: a share of zero is not followed", "[radiance]") {
  // Red through a green filter: the second sheet need not be looked through.
  Scene s;
  s.settings.background = grey(1);
  Material red = clear(1, 1), green = clear(1, 1);
  red.transmission.color = {1, 0, 0};
  green.transmission.color = {0, 1, 0};
  add_facet(s, {-9, -9, 1}, {9, -9, 1}, {0, 9, 1}, red);
  add_facet(s, {-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, green);
  const World world = prepare(s);
  const Plan needed = plan(s, {}, {});
  Tracer tracer({&world, &needed, nullptr});
  CHECK(is_black(tracer.radiance(Ray{{0, 0, 5}, {0, 0, -1}, 0, {}, {}}, 8)));
  CHECK(tracer.stats().refracted_rays == 1);
}

TEST_CASE("radiance: endless reflections end at once when cancelled", "[radiance]") {
  for (const auto sum : {scene::Sum::linear, scene::Sum::log}) {
    Scene s = mirror_hall(1, 2000000000);
    s.settings.ambient = {};
    s.settings.sum = sum;
    std::atomic<bool> cancel{false};
    Watch watch;
    watch.cancel = &cancel;
    std::thread stop([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      cancel = true;
    });
    Options options;
    options.samples = 1;
    options.threads = 2;
    const auto start = std::chrono::steady_clock::now();
    const Rendered out = render(s, view({0, 0, 0}, {0.01, 0, 1}, 8), options, watch);
    stop.join();
    CHECK(out.cancelled);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  }
}
