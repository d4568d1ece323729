#include "tracer/plan.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Plan planned(const Scene& s) { return plan(s, {}, {}); }

/// A glass ball, a lamp.
Scene glassy() {
  Scene s;
  add_sphere(s, {}, 1, clear(0.5, 1.5));
  s.lights.push_back(point_light({0, 5, 0}));
  return s;
}

}  // namespace

TEST_CASE("plan: a scene that needs everything leaves out nothing", "[plan]") {
  Scene s = glassy();
  s.materials[0].fresnel = true;
  const Plan p = planned(s);
  CHECK(p.shadows == ShadowWork::filtered);
  CHECK(p.reflects);
  CHECK(p.transmits);
  CHECK(p.media);
  CHECK(p.reasons.empty());
}

TEST_CASE("plan: an opaque matt scene needs first hits of shadow rays and no other rays", "[plan]") {
  Scene s;
  add_sphere(s, {}, 1);
  s.lights.push_back(point_light({0, 5, 0}));
  const Plan p = planned(s);
  CHECK(p.shadows == ShadowWork::blocked);
  CHECK_FALSE(p.reflects);
  CHECK_FALSE(p.transmits);
  CHECK_FALSE(p.media);
  CHECK(p.reasons ==
        std::vector<std::string>{"shadow rays stop at the first surface: no shape lets light through",
                                 "no reflected rays: no material reflects",
                                 "no transmitted rays: no material lets light through"});
}

TEST_CASE("plan: shadow rays are left out for one of three reasons", "[plan]") {
  Scene s = glassy();
  s.settings.shadows = scene::Shadows::off;
  CHECK(planned(s).shadows == ShadowWork::none);
  CHECK(planned(s).reasons[0] == "no shadow rays: the settings turn shadows off");
  s = glassy();
  s.lights.clear();
  CHECK(planned(s).shadows == ShadowWork::none);
  CHECK(planned(s).reasons[0] == "no shadow rays: there is no light");
  s = glassy();
  s.shapes[0].shadow = false;
  CHECK(planned(s).shadows == ShadowWork::none);
  CHECK(planned(s).reasons[0] == "no shadow rays: no shape casts a shadow");
}

TEST_CASE("plan: clear things that cast no shadow do not make shadows filtered", "[plan]") {
  Scene s = glassy();
  add_sphere(s, {0, 3, 0}, 1);
  s.shapes[0].shadow = false;
  CHECK(planned(s).shadows == ShadowWork::blocked);
  s.shapes[0].shadow = true;
  CHECK(planned(s).shadows == ShadowWork::filtered);
  s.settings.shadows = scene::Shadows::opaque;
  CHECK(planned(s).shadows == ShadowWork::blocked);
}

TEST_CASE("plan: open solids matter where indices differ and light goes through", "[plan]") {
  Scene s = glassy();
  s.materials[0].ior = 1;
  CHECK_FALSE(planned(s).media);
  CHECK(planned(s).reasons.back() == "no lists of open solids: all refractive indices are the same");
  s.settings.ior = 1.33;
  CHECK(planned(s).media);
  s = Scene{};
  add_facet(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, clear(1, 1.5));  // which encloses nothing
  CHECK_FALSE(planned(s).media);
}
