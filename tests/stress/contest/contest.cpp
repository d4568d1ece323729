#include "stress/contest/contest.hpp"

#include <fmt/format.h>

namespace lancer::stress::flat {

void Failure::tell(const Field& field, std::size_t ray, const std::string& numbers, const Truth& truth,
                   const Reported& got) {
  const bool wrong = is_wrong(truth, got);
  if (!text.empty() && (wrong_told || !wrong)) return;
  wrong_told = wrong;
  const auto what = [](bool hit, double t, int face, bool entering) {
    return hit ? fmt::format("t {:.17g} face {} {}", t, face, entering ? "entering" : "leaving")
               : std::string("none");
  };
  text = fmt::format("{} ray {}: {} {}: {}, in truth {}", field.set, ray, numbers, told(field.lines[ray]),
                     what(got.hit, got.t, got.face, got.entering),
                     what(truth.hit, to_double(truth.t), truth.face, truth.entering));
  if (got.hit && truth.hit) {
    text += fmt::format("; distance {:.3g}, point {:.3g}, normal {:.3g} ulp", ulps(got.t, truth.t),
                        ulps(got.point, truth.point), ulps(got.normal, truth.normal));
  }
}

}  // namespace lancer::stress::flat
