// Leaving out what is not needed changes no bit, and spares what it says.

#include "tracer/skip.hpp"

#include "catch.hpp"
#include "random_scene.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Rendered with_skips(const Scene& s, const scene::View& v, Skips skips, double error = 0) {
  Options options;
  options.samples = 3;
  options.threads = 1;
  options.skips = skips;
  options.error = error;
  return render(s, v, options);
}

/// What the render of a scene counts with all skips, and with all but one; each ray by itself, as groups of
/// rays ask for all their rays.
struct Counts {
  Stats on, off;
};

Counts counts(const Scene& s, Skip skip, double error = 0) {
  const scene::View v = view({0, 1, 6}, {0, -0.15, -1}, 24);
  const Skips alone = Skips::all().without(Skip::single_rays);
  const Rendered on = with_skips(s, v, alone, error);
  const Rendered off = with_skips(s, v, alone.without(skip), error);
  if (error == 0) CHECK(on.image.data() == off.image.data());
  return {on.stats, off.stats};
}

/// A matt ball on a floor under a lamp.
Scene matt_ball() {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1, matt(0.8));
  add_plane(s, {0, -1, 0}, {0, 1, 0}, matt(0.5));
  s.lights.push_back(point_light({4, 5, 3}, 0.9));
  return s;
}

Scene many_balls(const Material& m) {
  Scene s = matt_ball();
  for (int x = -3; x <= 3; ++x) {
    for (int z = -3; z <= 3; ++z) add_sphere(s, {x * 1.2, -0.7, z * 1.2}, 0.3, m);
  }
  return s;
}

}  // namespace

TEST_CASE("skip: no skip, and not all of them together, changes a bit of a random scene", "[skip]") {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const Scene s = random_scene(seed);
    const scene::View v = random_view(seed, 14, 10);
    const std::vector<float> picture = with_skips(s, v, Skips::all()).image.data();
    INFO("seed " << seed);
    REQUIRE(with_skips(s, v, Skips::none()).image.data() == picture);
    for (std::size_t i = 0; i < k_skip_names.size(); ++i) {
      const auto skip = static_cast<Skip>(i);
      INFO("without " << name_of(skip));
      REQUIRE(with_skips(s, v, Skips::all().without(skip)).image.data() == picture);
      INFO("with " << name_of(skip) << " alone");
      REQUIRE(with_skips(s, v, Skips::none().with(skip)).image.data() == picture);
    }
  }
}

TEST_CASE("skip: recursion spares the look for rays to go on with", "[skip]") {
  const Counts c = counts(matt_ball(), Skip::recursion);
  CHECK(c.on.branchings == 0);
  CHECK(c.off.branchings > 500);
}

TEST_CASE("skip: any-hit spares tests behind the first surface in the way", "[skip]") {
  const Counts c = counts(many_balls(matt(0.7)), Skip::any_hit);
  CHECK(c.on.shadow_rays == c.off.shadow_rays);
  CHECK(c.on.shape_tests < c.off.shape_tests);
}

TEST_CASE("skip: shadow-rays spares them where nothing casts a shadow", "[skip]") {
  Scene s = matt_ball();
  for (scene::Shape& shape : s.shapes) shape.shadow = false;
  const Counts c = counts(s, Skip::shadow_rays);
  CHECK(c.on.shadow_rays == 0);
  CHECK(c.off.shadow_rays > 500);
}

TEST_CASE("skip: dark-lights spares rays to lights behind, aimed elsewhere, or black", "[skip]") {
  const std::uint64_t before = counts(matt_ball(), Skip::dark_lights).on.shadow_rays;
  Scene s = matt_ball();
  s.lights.push_back(point_light({0, -9, 0}));    // below the floor: behind it, and behind half of the ball
  s.lights.push_back(point_light({1, 9, 0}, 0));  // off
  scene::Light spot = point_light({30, 5, 0});    // looking away
  spot.kind = scene::LightKind::spot;
  spot.direction = {1, 0, 0};
  s.lights.push_back(spot);
  const Counts c = counts(s, Skip::dark_lights);
  CHECK(c.on.shadow_rays >= before);
  CHECK(c.on.shadow_rays < before + before / 4);
  CHECK(c.off.shadow_rays > 3 * before);
  CHECK(c.on.lights_behind > 0);
  CHECK(c.on.lights_outside_cone > 0);
  CHECK(c.on.shadow_rays + c.on.lights_behind + c.on.lights_outside_cone + before >= c.off.shadow_rays / 2);
}

TEST_CASE("skip: single-rays spares visits of nodes", "[skip]") {
  const Scene s = many_balls(matt(0.7));
  const scene::View v = view({0, 1, 6}, {0, -0.15, -1}, 24);
  const Stats together = with_skips(s, v, Skips::all()).stats;
  const Stats alone = with_skips(s, v, Skips::all().without(Skip::single_rays)).stats;
  CHECK(together.shadow_rays == alone.shadow_rays);
  CHECK(together.node_visits * 2 < alone.node_visits);
}

TEST_CASE("skip: zero-terms spares rays to lights from a pure mirror", "[skip]") {
  Scene s = matt_ball();
  s.materials[0] = mirror(0.9);
  const Counts c = counts(s, Skip::zero_terms);
  CHECK(c.on.lights_unanswered > 100);
  CHECK(c.off.shadow_rays > c.on.shadow_rays);
  CHECK(c.off.lights_unanswered == 0);
}

TEST_CASE("skip: media spares lists of solids where all indices are the same", "[skip]") {
  const Counts c = counts(many_balls(clear(0.8, 1)), Skip::media);
  CHECK(c.on.medium_changes == 0);
  CHECK(c.off.medium_changes > 100);
}

TEST_CASE("skip: patterns spares colours that no term needs", "[skip]") {
  Scene s = matt_ball();
  s.settings.ambient = {};
  s.patterns.push_back({scene::Pattern::Kind::checker, grey(0.9), grey(0.2), 1, {}, {}, {}});
  s.materials[1].ambient.pattern = s.materials[1].diffuse.pattern = 0;
  const Counts c = counts(s, Skip::patterns);
  CHECK(c.on.pattern_lookups > 100);
  CHECK(c.off.pattern_lookups == 2 * c.on.pattern_lookups);  // the ambient colour too
}

TEST_CASE("skip: tree spares nodes where there is little to ask", "[skip]") {
  const Counts c = counts(matt_ball(), Skip::tree);
  CHECK(c.on.node_visits == 0);
  CHECK(c.off.node_visits > 500);
  CHECK(counts(many_balls(matt(0.7)), Skip::tree).on.node_visits > 500);
}

TEST_CASE("skip: the names are sorted, and found", "[skip]") {
  CHECK(std::is_sorted(k_skip_names.begin(), k_skip_names.end()));
  CHECK(skip_from_name("faint-rays") == Skip::faint_rays);
  CHECK(name_of(Skip::zero_terms) == "zero-terms");
  CHECK_FALSE(skip_from_name("faint"));
  CHECK(Skips::all().without(Skip::tree).with(Skip::tree) == Skips::all());
  CHECK_FALSE(Skips::none().has(Skip::media));
}
