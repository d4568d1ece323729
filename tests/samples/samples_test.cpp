// Every sample runs without a word, and every view of it gives the picture that lies in tests/pictures, pixel
// for pixel. With LANCER_REFRESH_PICTURES=1 in the environment the pictures are written anew instead: look at
// them before committing.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <png.h>
#include <vector>

#include "catch.hpp"
#include "each_sample.hpp"
#include "image/encode.hpp"

namespace {

namespace fs = std::filesystem;
using namespace lancer;

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

/// The picture of a view, small, as PNG.
std::string small_picture(const session::Session& session, const scene::View& view) {
  tracer::Options options;
  test::make_small(view, options);
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
  const Pixels expected = decode_png(test::read_file(golden));
  const Pixels actual = decode_png(picture);
  REQUIRE(actual.width == test::k_columns);
  CHECK(expected.width == actual.width);
  CHECK(expected.height == actual.height);
  CHECK((expected.rgb == actual.rgb));
}

}  // namespace

TEST_CASE("every sample gives the picture that it gave before", "[samples]") {
  test::each_view([](const std::string& name, const session::Session& session, const scene::View& view) {
    compare(fs::path(LANCER_PICTURES_FOLDER) / (name + ".png"), small_picture(session, view));
  });
}
