#include "stress/contest.hpp"

#include <fmt/format.h>

namespace lancer::stress::flat {

std::string exactly(Vec3 v) { return fmt::format("<{:a}, {:a}, {:a}>", v.x, v.y, v.z); }

void Failure::tell(const Field& field, std::size_t ray, const std::string& numbers, const Truth& truth,
                   const Reported& got) {
  const bool wrong = truth.hit != got.hit || truth.face != got.face || truth.entering != got.entering;
  if (!text.empty() && (wrong_told || !wrong)) return;
  wrong_told = wrong;
  const Line& line = field.lines[ray];
  const auto what = [](bool hit, double t, int face, bool entering) {
    return hit ? fmt::format("t {:.17g} face {} {}", t, face, entering ? "entering" : "leaving")
               : std::string("none");
  };
  text =
      fmt::format("{} ray {}: {} origin {} direction {}: {}, in truth {}", field.set, ray, numbers,
                  exactly(line.origin), exactly(line.direction), what(got.hit, got.t, got.face, got.entering),
                  what(truth.hit, to_double(truth.t), truth.face, truth.entering));
  if (got.hit && truth.hit) {
    text += fmt::format("; distance {:.3g}, point {:.3g}, normal {:.3g} ulp", ulps(got.t, truth.t),
                        ulps(got.point, truth.point), ulps(got.normal, truth.normal));
  }
}

}  // namespace lancer::stress::flat
