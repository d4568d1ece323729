// lancer-need [PAIRS]: a table of what each feature costs, added to the plain scene, and to all before it.

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>

#include "bench/need/features.hpp"

namespace lancer::need {
namespace {

constexpr int k_columns = 320, k_rows = 200, k_samples = 4;

struct Timed {
  Drawn drawn;
  double seconds = 0;  // of the processor, from prepare to picture
};

Timed timed(const std::string& script) {
  Timed out{draw(script, k_columns, k_rows, k_samples)};
  out.seconds = out.drawn.stats.build_seconds + out.drawn.stats.render_seconds;
  return out;
}

/// The median, least and most of how much longer `with` takes than `without`, drawn in turn.
std::string ratio(const std::string& with, const std::string& without, int pairs) {
  std::vector<double> ratios;
  for (int i = 0; i < pairs; ++i) {
    const bool swap = i % 2 != 0;
    const double first = timed(swap ? without : with).seconds, second = timed(swap ? with : without).seconds;
    ratios.push_back(swap ? second / first : first / second);
  }
  std::sort(ratios.begin(), ratios.end());
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", ratios[ratios.size() / 2], ratios.front(), ratios.back());
}

void row(const std::string& name, const Drawn& drawn, const std::string& alone, const std::string& so_far) {
  const tracer::Stats& s = drawn.stats;
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", name, s.primary_rays,
             s.reflected_rays + s.refracted_rays, s.shadow_rays, s.shape_tests, s.node_visits, alone, so_far);
  std::fflush(stdout);
}

int table(int pairs) {
  fmt::print(
      "| added | primary rays | onward rays | shadow rays | shape tests | nodes | time, alone | time, with "
      "all above |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const std::string plain = plain_script();
  row("nothing", timed(plain).drawn, "1", "1");
  std::string so_far = plain;
  for (const Feature& feature : features()) {
    so_far += feature.script + "\n";
    const std::string alone = plain + feature.script;
    row(feature.name + (feature.shows ? "" : " (does not show)"), timed(alone).drawn,
        ratio(alone, plain, pairs), ratio(so_far, plain, pairs));
  }
  return 0;
}

}  // namespace
}  // namespace lancer::need

int main(int argc, char** argv) {
  return lancer::need::table(argc > 1 ? std::max(1, std::atoi(argv[1])) : 7);
}
