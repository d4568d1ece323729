// lancer-error [OPTION...] SCRIPT...: how far pictures are from the truth, and what they cost. A row for each
// view and setting, as tab-separated values.
//
//   --width N            columns of the pictures (96)
//   --errors E,E,...     what to ask for (0.1,0.05,0.02,0.01,0.005)
//   --samples N,N,...    equal samples, to compare with (none)
//   --references FOLDER  where the true pictures are kept (references)
//   --map FOLDER         put a picture of the errors there for each row, white where larger than asked for

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

#include "bench/error/measure.hpp"
#include "folder_host.hpp"
#include "image/encode.hpp"

namespace lancer::bench {
namespace {

struct Settings {
  int width = 96;
  std::vector<double> errors{0.1, 0.05, 0.02, 0.01, 0.005};
  std::vector<double> samples;
  std::string references = "references", maps;
  std::vector<std::string> scripts;
};

std::vector<double> numbers(const std::string& text) {
  std::vector<double> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    out.push_back(std::stod(text.substr(at, end - at)));
    at = end + 1;
  }
  return out;
}

Settings read_arguments(const std::vector<std::string>& arguments) {
  Settings out;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word.rfind("--", 0) != 0) {
      out.scripts.push_back(word);
      continue;
    }
    if (i + 1 == arguments.size()) throw std::runtime_error(word + " wants a value");
    const std::string& value = arguments[++i];
    if (word == "--width") {
      out.width = std::stoi(value);
    } else if (word == "--errors") {
      out.errors = numbers(value);
    } else if (word == "--samples") {
      out.samples = numbers(value);
    } else if (word == "--references") {
      out.references = value;
    } else if (word == "--map") {
      out.maps = value;
    } else {
      throw std::runtime_error("there is no option " + word);
    }
  }
  return out;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void draw_map(const Errors& e, const Subject& subject, double asked, const std::string& path) {
  image::Image map(subject.columns, subject.rows);
  for (std::size_t i = 0; i < e.pixels.size(); ++i) {
    const int x = static_cast<int>(i) % subject.columns, y = static_cast<int>(i) / subject.columns;
    for (float& value : map.pixel(x, y))
      value = static_cast<float>(e.pixels[i] > asked ? 1 : 0.3 * e.pixels[i] / asked);
  }
  std::ofstream(path, std::ios::binary) << image::encode(map, image::Format::png8, 1);
}

void row(const session::Session& session, const scene::View& view, const Subject& subject,
         tracer::Options options, const Settings& settings) {
  options.columns = subject.columns;
  options.rows = subject.rows;
  options.threads = 1;
  const double start = processor_seconds();
  const tracer::Rendered drawn = session.render(view, options);
  const double seconds = processor_seconds() - start;
  const Errors e = errors(drawn.image, subject.truth, session.scene().settings.exposure);
  const auto pixels = static_cast<double>(e.pixels.size());
  const bool equal = options.samples > 0;
  const std::string setting =
      equal ? fmt::format("n={}", options.samples) : fmt::format("e={}", options.error);
  fmt::print("{}\t{}\t{}\t{:.4f}\t{:.5f}\t{:.5f}\t{:.2f}\t{:.3f}\t{:.3f}\t{:.3f}\n", subject.name, setting,
             equal ? "" : fmt::format("{:.2f}", 100 * e.share_within(options.error)), e.quantile(0.99),
             e.mean_square, e.linear, static_cast<double>(drawn.stats.primary_rays) / pixels,
             static_cast<double>(drawn.stats.refined_pixels) / pixels,
             static_cast<double>(drawn.stats.edge_pixels) / pixels, seconds);
  std::fflush(stdout);
  if (!settings.maps.empty()) {
    draw_map(e, subject, equal ? e.quantile(0.99) : options.error,
             fmt::format("{}/{}-{}.png", settings.maps, subject.name, setting));
  }
}

void measure(const std::string& script, const Settings& settings) {
  test::FolderHost host;
  session::Session session(host);
  if (session.run_file(script, {}).outcome != session::Outcome::fine)
    throw std::runtime_error(script + " cannot be drawn; lancer check tells why");
  const std::vector<scene::View> views = session.views();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Subject wanted = subject(session, script, i, settings.width, settings.references);
    for (const double error : settings.errors) {
      tracer::Options options;
      options.samples = 0;
      options.error = error;
      row(session, views[i], wanted, options, settings);
    }
    for (const double samples : settings.samples) {
      tracer::Options options;
      options.samples = static_cast<int>(samples);
      row(session, views[i], wanted, options, settings);
    }
  }
}

}  // namespace
}  // namespace lancer::bench

int main(int argc, char** argv) {
  try {
    const auto settings = lancer::bench::read_arguments({argv + 1, argv + argc});
    fmt::print("view\tsetting\t% within\t99% within\tRMSE\tlinear RMSE\tsamples\trefined\tedges\tseconds\n");
    for (const std::string& script : settings.scripts) lancer::bench::measure(script, settings);
    return 0;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "lancer-error: {}\n", problem.what());
    return 2;
  }
}
