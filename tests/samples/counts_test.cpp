// What drawing each sample takes, counted: rays by kind, tests of shapes, visits of nodes. Times are noisy,
// counts are not: a change that makes the tracer do more shows here. With LANCER_REFRESH_COUNTS=1 in the
// environment the counts are written anew instead.

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "each_sample.hpp"
#include "tracer/render.hpp"

namespace {

using namespace lancer;

constexpr const char* k_heading =
    "view\trays\tprimary\treflected\trefracted\tshadow\tshape tests\tnode visits\n";

void count(std::ostream& out, const session::Session& session, const scene::View& view, bool together) {
  tracer::Options options;
  test::make_small(view, options);
  options.samples = 1;
  if (!together) options.skips = options.skips.without(tracer::Skip::single_rays);
  const tracer::Stats s = session.render(view, options).stats;
  out << '\t' << (together ? "together" : "one by one") << '\t' << s.primary_rays << '\t' << s.reflected_rays
      << '\t' << s.refracted_rays << '\t' << s.shadow_rays << '\t' << s.shape_tests << '\t' << s.node_visits
      << '\n';
}

}  // namespace

TEST_CASE("every sample takes the rays, tests and node visits that it took before", "[samples]") {
  std::ostringstream counts;
  counts << k_heading;
  test::each_view([&](const std::string& name, const session::Session& session, const scene::View& view) {
    for (const bool together : {true, false}) {
      counts << name;
      count(counts, session, view, together);
    }
  });
  if (std::getenv("LANCER_REFRESH_COUNTS") != nullptr) {
    std::ofstream(LANCER_COUNTS_FILE, std::ios::binary) << counts.str();
    return;
  }
  CHECK(counts.str() == test::read_file(LANCER_COUNTS_FILE));
}
