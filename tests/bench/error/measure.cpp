#include "bench/error/measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

#include "base/math.hpp"
#include "image/encode.hpp"

namespace lancer::bench {
namespace {

/// A PFM of three channels and little-endian floats, as Lancer writes it: rows from the bottom.
image::Image read_pfm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string kind;
  int width = 0, height = 0;
  double scale = 0;
  file >> kind >> width >> height >> scale;
  file.get();
  if (!file || kind != "PF" || scale >= 0) throw std::runtime_error(path + " is no PFM of this machine's");
  image::Image out(width, height);
  for (int y = height - 1; y >= 0; --y) {
    const std::streamsize bytes = static_cast<std::streamsize>(sizeof(float)) * 3 * width;
    file.read(reinterpret_cast<char*>(out.pixel(0, y).data()), bytes);
  }
  if (!file) throw std::runtime_error(path + " is too short");
  return out;
}

image::Image true_picture(const session::Session& session, const scene::View& view, const Subject& subject,
                          const std::string& path) {
  if (std::filesystem::exists(path)) return read_pfm(path);
  tracer::Options options;
  options.columns = subject.columns;
  options.rows = subject.rows;
  options.samples = k_true_samples;
  image::Image picture = session.render(view, options).image;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path, std::ios::binary)
      << image::encode(picture, image::Format::pfm, session.scene().settings.exposure);
  return picture;
}

double clamped(float light, double exposure) {
  return std::clamp(static_cast<double>(light) * exposure, 0.0, 1.0);
}

}  // namespace

Subject subject(const session::Session& session, const std::string& script, std::size_t view, int columns,
                const std::string& folder) {
  const std::vector<scene::View> views = session.views();
  Subject out;
  out.columns = columns;
  out.rows = std::max(1, columns * views[view].rows / views[view].columns);
  out.name = std::filesystem::path(script).stem().string();
  if (views.size() > 1) out.name += "-" + session.view_name(view);
  out.name += fmt::format("-{}x{}", out.columns, out.rows);
  out.truth = true_picture(session, views[view], out, folder + "/" + out.name + ".pfm");
  return out;
}

double Errors::share_within(double error) const {
  const auto within = std::count_if(pixels.begin(), pixels.end(), [=](double e) { return e <= error; });
  return static_cast<double>(within) / static_cast<double>(pixels.size());
}

double Errors::quantile(double share) const {
  std::vector<double> sorted = pixels;
  std::sort(sorted.begin(), sorted.end());
  const double place = std::ceil(share * static_cast<double>(sorted.size())) - 1;
  return sorted[static_cast<std::size_t>(std::max(0.0, place))];
}

Errors errors(const image::Image& picture, const image::Image& truth, double exposure) {
  Errors out;
  double squares = 0, linear_squares = 0;
  for (std::size_t i = 0; i < truth.data().size(); i += 3) {
    double worst = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const double is = clamped(picture.data()[c], exposure), should = clamped(truth.data()[c], exposure);
      const double off = std::fabs(math::linear_to_srgb(is) - math::linear_to_srgb(should));
      worst = std::max(worst, off);
      squares += off * off;
      linear_squares += (is - should) * (is - should);
    }
    out.pixels.push_back(worst);
  }
  const auto count = static_cast<double>(truth.data().size());
  out.mean_square = std::sqrt(squares / count);
  out.linear = std::sqrt(linear_squares / count);
  return out;
}

}  // namespace lancer::bench
