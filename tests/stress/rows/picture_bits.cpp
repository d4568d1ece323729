// Pictures that must be the same to the bit.

#include <cmath>
#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/standard.hpp"
#include "stress/truth/reference/pictures.hpp"
#include "tracer/render.hpp"

namespace lancer::stress {
namespace {

/// Pixels whose bits differ.
std::uint64_t other_bits(const image::Image& a, const image::Image& b) {
  std::uint64_t count = a.data().size() == b.data().size() ? 0 : 1;
  for (std::size_t i = 0; i < a.data().size() && i < b.data().size(); ++i)
    count += a.data()[i] == b.data()[i] ? 0 : 1;
  return count;
}

Outcome bits(const Settings& settings) {
  const int size = settings.full ? 128 : 48;
  tracer::Options options;
  options.samples = settings.full ? 4 : 1;
  const auto picture = [&](double s, int threads) {
    const Script script(Standard{s, {}}.text(size));
    options.threads = threads;
    return tracer::render(script.scene, script.view, options).image;
  };
  const image::Image plain = picture(1, 1);
  Outcome out;
  for (const int k : {-100, -40, -10, -1, 1, 10, 40, 100}) {
    out.limits.push_back({fmt::format("pixels changed by 2^{}", k),
                          static_cast<double>(other_bits(plain, picture(std::ldexp(1.0, k), 1))), 0});
  }
  for (const int threads : {2, 7}) {
    out.limits.push_back({fmt::format("pixels changed by {} threads", threads),
                          static_cast<double>(other_bits(plain, picture(1, threads))), 0});
  }
  return out;
}

}  // namespace

void add_picture_bits_rows(Rows& rows) {
  rows.push_back(
      {"picture.bits", "the same bits when scaled by powers of two and by any number of threads", bits});
}

}  // namespace lancer::stress
