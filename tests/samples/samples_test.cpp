// Every sample runs without a word, and every view of it gives the picture that lies in tests/pictures, pixel
// for pixel. With LANCER_REFRESH_PICTURES=1 in the environment the pictures are written anew instead: look at
// them before committing.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <png.h>
#include <vector>

#include "catch.hpp"
#include "folder_host.hpp"
#include "image/encode.hpp"
#include "session/session.hpp"

namespace {

namespace fs = std::filesystem;
using namespace lancer;

constexpr int k_columns = 96;

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

Pixels decode_png(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return {};
  png.format = PNG_FORMAT_RGB;
  Pixels out{static_cast<int>(png.width), static_cast<int>(png.height),
             std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  png_image_finish_read(&png, nullptr, out.rgb.data(), 0, nullptr);
  return out;
}

std::string read_file(const fs::path& path) {
  test::FolderHost host;
  return host.read(path.string()).text;
}

std::vector<fs::path> samples() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(LANCER_SAMPLES_FOLDER)) {
    if (entry.path().extension() == ".scn") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// The picture of a view, small, as PNG.
std::string small_picture(const session::Session& session, const scene::View& view) {
  tracer::Options options;
  options.columns = k_columns;
  options.rows = std::max(1, k_columns * view.rows / view.columns);
  options.samples = 4;
  const tracer::Rendered out = session.render(view, options);
  return image::encode(out.image, image::Format::png8, session.scene().settings.exposure);
}

void compare(const fs::path& golden, const std::string& picture) {
  INFO(golden.filename().string());
  if (std::getenv("LANCER_REFRESH_PICTURES") != nullptr) {
    std::ofstream(golden, std::ios::binary) << picture;
    return;
  }
  const Pixels expected = decode_png(read_file(golden));
  const Pixels actual = decode_png(picture);
  REQUIRE(actual.width == k_columns);
  CHECK(expected.width == actual.width);
  CHECK(expected.height == actual.height);
  CHECK((expected.rgb == actual.rgb));
}

}  // namespace

TEST_CASE("every sample gives the picture that it gave before", "[samples]") {
  const std::vector<fs::path> all = samples();
  REQUIRE(all.size() >= 12);
  for (const fs::path& path : all) {
    INFO(path.filename().string());
    test::FolderHost host;
    session::Session session(host);
    const session::Run run = session.run_file(path.string(), {});
    CHECK(to_text(run.diagnostics, session.sources()) == "");
    REQUIRE(run.outcome == session::Outcome::fine);
    const std::vector<scene::View> views = session.views();
    for (std::size_t i = 0; i < views.size(); ++i) {
      std::string name = path.stem().string();
      if (views.size() > 1) name.append("-").append(session.view_name(i));
      compare(fs::path(LANCER_PICTURES_FOLDER) / name.append(".png"), small_picture(session, views[i]));
    }
  }
}
