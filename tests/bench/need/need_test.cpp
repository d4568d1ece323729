// Cost follows need: what does not show costs no rays.

#include "bench/need/features.hpp"
#include "catch.hpp"

using namespace lancer;
using need::draw;
using need::Drawn;
using need::Feature;
using need::features;

namespace {

Drawn small(const std::string& script) { return draw(script, 48, 30, 2); }

std::uint64_t rays(const tracer::Stats& s) {
  return s.primary_rays + s.reflected_rays + s.refracted_rays + s.shadow_rays;
}

}  // namespace

TEST_CASE("what does not show casts no ray, and hardly a test more", "[need]") {
  const Drawn plain = small(need::plain_script());
  for (const Feature& feature : features()) {
    if (feature.shows) continue;
    INFO(feature.name);
    const Drawn with = small(need::plain_script() + feature.script);
    CHECK(with.picture == plain.picture);
    CHECK(rays(with.stats) == rays(plain.stats));
    CHECK(with.stats.pattern_lookups == 0);
    CHECK(with.stats.medium_changes == 0);
    CHECK(with.stats.branchings == 0);
    // Another tree, which is not as good everywhere.
    CHECK(with.stats.shape_tests < plain.stats.shape_tests + plain.stats.shape_tests / 2);
  }
}

TEST_CASE("all together, what does not show costs no more", "[need]") {
  const Drawn plain = small(need::plain_script());
  std::string script = need::plain_script();
  for (const Feature& feature : features()) script += feature.shows ? "" : feature.script + "\n";
  const Drawn with = small(script);
  CHECK(with.picture == plain.picture);
  CHECK(rays(with.stats) == rays(plain.stats));
}

TEST_CASE("what shows costs what it needs", "[need]") {
  const Drawn plain = small(need::plain_script());
  for (const Feature& feature : features()) {
    if (!feature.shows) continue;
    INFO(feature.name);
    const Drawn with = small(need::plain_script() + feature.script);
    CHECK(with.picture != plain.picture);
    CHECK(rays(with.stats) < 3 * rays(plain.stats));
  }
}
