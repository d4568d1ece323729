#include "tracer/crossings.hpp"

#include <tuple>

namespace lancer::tracer {

void join(std::vector<Crossing>& rims) {
  std::sort(rims.begin(), rims.end(), [](const Crossing& a, const Crossing& b) {
    return std::make_tuple(a.shape, a.root.t, a.primitive) < std::make_tuple(b.shape, b.root.t, b.primitive);
  });
  std::vector<Crossing> kept;
  for (auto first = rims.begin(); first != rims.end();) {
    int way = 0;
    auto last = first;
    for (; last != rims.end() && last->shape == first->shape &&
           last->root.t - last->root.error <= first->root.t + first->root.error;
         ++last) {
      way += last->root.entering ? 1 : -1;
    }
    for (; first != last; ++first) {
      if (way == 0 || first->root.entering == (way > 0)) kept.push_back(*first);
    }
  }
  rims = kept;
}

}  // namespace lancer::tracer
