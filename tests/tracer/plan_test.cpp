#include "tracer/plan.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Plan planned(const Scene& s, Skips skips = Skips::all(), double error = 0) {
  Options options;
  options.skips = skips;
  options.error = error;
  return plan(s, view({0, 0, 9}, {0, 0, -1}), options);
}

const Decision& decision(const Plan& p, Skip skip) { return p.decisions.at(static_cast<std::size_t>(skip)); }
Verdict verdict(const Plan& p, Skip skip) { return decision(p, skip).verdict; }
std::string reason(const Scene& s, Skip skip, double error = 0) {
  return in_words(s, decision(planned(s, Skips::all(), error), skip));
}

/// A glass ball, a lamp.
Scene glassy() {
  Scene s;
  add_sphere(s, {}, 1, clear(0.5, 1.5));
  s.materials[0].diffuse.color = grey(0.2);
  s.lights.push_back(point_light({0, 5, 0}));
  return s;
}

Index name(Scene& s, const std::string& text) {
  s.names.push_back(text);
  return static_cast<Index>(s.names.size() - 1);
}

}  // namespace

TEST_CASE("plan: there is one decision for each skip, in the order of their names", "[plan]") {
  const Plan p = planned(glassy());
  REQUIRE(p.decisions.size() == k_skip_names.size());
  for (std::size_t i = 0; i < p.decisions.size(); ++i) CHECK(p.decisions[i].skip == static_cast<Skip>(i));
}

TEST_CASE("plan: glass needs recursion, filtered shadows and lists of open solids", "[plan]") {
  Scene s = glassy();
  s.materials[0].fresnel = true;
  s.shapes[0].name = name(s, "ball");
  const Plan p = planned(s);
  CHECK(p.shadows == ShadowWork::filtered);
  CHECK(p.recursion);
  CHECK(p.reflects);
  CHECK(p.transmits);
  CHECK(p.media);
  CHECK(reason(s, Skip::recursion) == "`ball` may reflect or let light through");
  CHECK(reason(s, Skip::any_hit) == "light may come through `ball`");
  CHECK(reason(s, Skip::media) == "`ball` may bend light");
  CHECK(reason(s, Skip::shadow_rays) == "`ball` may stand between a light and a surface");
}

TEST_CASE("plan: an opaque matt scene needs first hits of shadow rays and no other rays", "[plan]") {
  Scene s;
  add_sphere(s, {}, 1);
  s.lights.push_back(point_light({0, 5, 0}));
  const Plan p = planned(s);
  CHECK(p.shadows == ShadowWork::blocked);
  CHECK_FALSE(p.recursion);
  CHECK_FALSE(p.media);
  CHECK(verdict(p, Skip::recursion) == Verdict::skipped);
  CHECK(reason(s, Skip::recursion) == "nothing reflects or lets light through");
  CHECK(reason(s, Skip::any_hit) == "nothing that casts a shadow lets light through");
}

TEST_CASE("plan: what is turned off is done, and said to be", "[plan]") {
  Scene s;
  add_sphere(s, {}, 1);
  s.lights.push_back(point_light({0, 5, 0}));
  const Plan p = planned(s, Skips::all().without(Skip::recursion).without(Skip::any_hit));
  CHECK(p.recursion);
  CHECK(p.shadows == ShadowWork::filtered);
  CHECK(verdict(p, Skip::recursion) == Verdict::off);
  CHECK(verdict(p, Skip::any_hit) == Verdict::off);
  CHECK(verdict(p, Skip::media) == Verdict::skipped);
}

TEST_CASE("plan: nothing goes on at depth 0", "[plan]") {
  Scene s = glassy();
  s.settings.depth = 0;
  CHECK_FALSE(planned(s).recursion);
  CHECK_FALSE(planned(s).media);
  CHECK(reason(s, Skip::recursion) == "the settings follow rays to depth 0");
}

TEST_CASE("plan: shadow rays are left out for one of four reasons", "[plan]") {
  Scene s = glassy();
  s.settings.shadows = scene::Shadows::off;
  CHECK(planned(s).shadows == ShadowWork::none);
  CHECK(reason(s, Skip::shadow_rays) == "the settings turn shadows off");
  s = glassy();
  s.lights.clear();
  CHECK(planned(s).shadows == ShadowWork::none);
  CHECK(reason(s, Skip::shadow_rays) == "there is no light");
  s = glassy();
  s.shapes[0].shadow = false;
  CHECK(planned(s).shadows == ShadowWork::none);
  CHECK(reason(s, Skip::shadow_rays) == "no shape casts a shadow");
  s = glassy();
  s.materials[0].diffuse.color = {};
  CHECK(planned(s).shadows == ShadowWork::none);
  CHECK(reason(s, Skip::shadow_rays) == "no surface is diffuse or specular");
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
  CHECK(reason(s, Skip::media) == "all refractive indices are the same");
  s.settings.ior = 1.33;
  CHECK(planned(s).media);
  s = Scene{};
  add_facet(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, clear(1, 1.5));  // which encloses nothing
  CHECK_FALSE(planned(s).media);
}

TEST_CASE("plan: open solids matter where a ray may be inside a solid mesh", "[plan]") {
  Scene s;
  add_mesh(s, cube_mesh(true), matt(0.5));
  CHECK_FALSE(planned(s).media);
  Options options;
  CHECK(plan(s, view({0.5, 0, 0}, {0, 0, -1}), options).media);
  s.materials[0] = clear(0.5, 1);
  CHECK(planned(s).media);
  CHECK(reason(s, Skip::media) == "rays may be inside mesh 1, of solid facets");
  s.meshes[0].solid = false;
  CHECK_FALSE(planned(s).media);
}

TEST_CASE("plan: materials that no shape wears do not exist", "[plan]") {
  Scene s;
  add_sphere(s, {}, 1);
  s.lights.push_back(point_light({0, 5, 0}));
  Material odd = clear(0.9, 1.5);
  odd.fresnel = true;
  for (int i = 0; i < 1000; ++i) s.materials.push_back(odd);
  const Plan p = planned(s);
  CHECK_FALSE(p.recursion);
  CHECK_FALSE(p.media);
  CHECK(p.shadows == ShadowWork::blocked);
}

TEST_CASE("plan: each material needs what its own terms need", "[plan]") {
  Scene s = glassy();
  add_sphere(s, {3, 0, 0}, 1, mirror(0.5));
  add_sphere(s, {6, 0, 0}, 1, matt(0.5));
  const Plan p = planned(s);
  CHECK(p.needs_of(0).direct);
  CHECK(p.needs_of(0).onward);
  CHECK_FALSE(p.needs_of(1).direct);
  CHECK(p.needs_of(1).onward);
  CHECK(p.needs_of(2).direct);
  CHECK_FALSE(p.needs_of(2).onward);
  CHECK_FALSE(p.needs_of(2).pattern);
  CHECK(reason(s, Skip::zero_terms) == "sphere 2: neither diffuse nor specular");
}

TEST_CASE("plan: black lights are not asked", "[plan]") {
  Scene s = glassy();
  s.lights.push_back(point_light({1, 5, 0}, 0));
  s.lights.push_back(point_light({2, 5, 0}));
  s.lights[1].name = name(s, "night");
  const Plan p = planned(s);
  CHECK_FALSE(p.every_light);
  CHECK(p.lights == std::vector<Index>{0, 2});
  CHECK(reason(s, Skip::dark_lights) == "nowhere: `night`");
  CHECK(planned(s, Skips::none()).every_light);
}

TEST_CASE("plan: few things are asked one by one", "[plan]") {
  Scene s;
  const Skips alone = Skips::all().without(Skip::single_rays);
  const auto add_spheres = [&](std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) add_sphere(s, {3.0 * static_cast<double>(i), 0, 0}, 1);
  };
  add_spheres(k_longest_list_of_spheres);
  CHECK_FALSE(planned(s, alone).tree);
  CHECK(planned(s, alone.without(Skip::tree)).tree);
  add_sphere(s, {0, 5, 0}, 1);
  CHECK(planned(s, alone).tree);
  CHECK_FALSE(planned(s).tree);  // Rays that go together ask more of them as fast.
  while (s.shapes.size() < k_longest_packet_list) add_sphere(s, {0, 9, 0}, 1);
  CHECK_FALSE(planned(s).tree);
  add_sphere(s, {0, 9, 3}, 1);
  CHECK(planned(s).tree);
  s = Scene{};
  add_spheres(k_longest_list - 1);
  add_box(s, {0, 5, 0}, {1, 6, 1});
  CHECK_FALSE(planned(s, alone).tree);
  add_sphere(s, {0, 9, 0}, 1);
  CHECK(planned(s, alone).tree);
  s = Scene{};
  add_mesh(s, cube_mesh(true));  // of 12 facets
  CHECK(planned(s, alone).tree);
  CHECK_FALSE(planned(s).tree);
}

TEST_CASE("plan: reasons name a few things, and count the others", "[plan]") {
  Scene s;
  for (int i = 0; i < 5; ++i) {
    Material m = mirror(0.1 * (i + 1));
    add_sphere(s, {3.0 * i, 0, 0}, 1, m);
  }
  CHECK(reason(s, Skip::recursion) ==
        "sphere 1, sphere 2, sphere 3 and 2 more may reflect or let light through");
}

TEST_CASE("plan: faint rays are left out only for an error, and only below a bound", "[plan]") {
  Scene s = glassy();
  CHECK_FALSE(planned(s).faint_rays);
  CHECK(planned(s, Skips::all(), 0.01).faint_rays);
  CHECK_FALSE(planned(s, Skips::all().without(Skip::faint_rays), 0.01).faint_rays);
  s.lights[0].at = {0, 0.5, 0};
  s.lights[0].falloff = 1;
  CHECK(planned(s, Skips::all(), 0.01).faint_rays);
  s.lights[0].at = {0, 1, 0};  // on the ball
  CHECK_FALSE(planned(s, Skips::all(), 0.01).faint_rays);
  CHECK(reason(s, Skip::faint_rays, 0.01) == "light 1 may be next to a surface, and so without bound");
  s = glassy();
  s.materials[0].transmission.color = grey(1.5);
  CHECK_FALSE(planned(s, Skips::all(), 0.01).faint_rays);
  CHECK_FALSE(planned(s, Skips::all(), 0.01).faint_lights);
}
