#include <cstdint>
#include <png.h>
#include <string>
#include <vector>

#include "base/math.hpp"
#include "catch.hpp"
#include "image/encode.hpp"
#include "image/tone.hpp"
#include "pictures.hpp"

using namespace lancer::image;

namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

/// The chunks' types in order, such as "IHDR sRGB IDAT IEND", each once where it repeats.
std::string chunks(const std::string& png) {
  std::string names, last;
  for (std::size_t at = 8; at < png.size();) {
    const std::string name = png.substr(at + 4, 4);
    if (name != last) names += (names.empty() ? "" : " ") + name;
    last = name;
    at += big_endian(png, at) + 12;
  }
  return names;
}

struct Source {
  const std::string& bytes;
  std::size_t at = 0;
};

void read(png_structp png, png_bytep data, std::size_t length) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (length > source.bytes.size() - source.at) png_error(png, "short");
  source.bytes.copy(reinterpret_cast<char*>(data), length, source.at);
  source.at += length;
}

struct Decoded {
  unsigned width = 0, height = 0;
  int bit_depth = 0, color_type = 0, intent = -1;
  std::vector<unsigned> values;  // row by row from the top
};

/// By libpng's low-level reader. An error ends the test program: there should be none.
Decoded decode(const std::string& bytes) {
  Decoded out;
  Source source{bytes};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &source, read);
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  out.width = png_get_image_width(png, info);
  out.height = png_get_image_height(png, info);
  out.bit_depth = png_get_bit_depth(png, info);
  out.color_type = png_get_color_type(png, info);
  png_get_sRGB(png, info, &out.intent);
  png_bytepp rows = png_get_rows(png, info);
  for (unsigned y = 0; y < out.height; ++y) {
    for (unsigned i = 0; i < out.width * 3; ++i) {
      out.values.push_back(out.bit_depth == 8 ? unsigned{rows[y][i]}
                                              : unsigned{rows[y][2 * i]} << 8 | rows[y][2 * i + 1]);
    }
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return out;
}

}  // namespace

TEST_CASE("png: 8 bits a channel, values worked out by hand", "[png]") {
  const Decoded png =
      decode(encode(make_image(2, 2, {0, 0.5F, 1, 2, -1, 0.25F, 1, 0, 0, 0, 0, 1}), Format::png8, 1));
  CHECK(png.width == 2);
  CHECK(png.height == 2);
  CHECK(png.bit_depth == 8);
  CHECK(png.color_type == PNG_COLOR_TYPE_RGB);
  CHECK(png.intent == PNG_sRGB_INTENT_PERCEPTUAL);
  CHECK(png.values == std::vector<unsigned>{0, 188, 255, 255, 0, 137, 255, 0, 0, 0, 0, 255});
}

TEST_CASE("png: 16 bits a channel, values worked out by hand", "[png]") {
  const Decoded png =
      decode(encode(make_image(3, 1, {0, 0.5F, 1, 2, -1, 0.25F, 0.001953125F, 0, 0}), Format::png16, 1));
  CHECK(png.bit_depth == 16);
  CHECK(png.color_type == PNG_COLOR_TYPE_RGB);
  CHECK(png.intent == PNG_sRGB_INTENT_PERCEPTUAL);
  CHECK(png.values == std::vector<unsigned>{0, 48192, 65535, 65535, 0, 35199, 1654, 0, 0});
}

TEST_CASE("png: a larger picture comes back with the codes of the tone curve", "[png]") {
  const Image image = make_ramp(50, 41);
  const ToneCurve curve(0.01);
  const Decoded eight = decode(encode(image, Format::png8, 0.01));
  const Decoded sixteen = decode(encode(image, Format::png16, 0.01));
  REQUIRE(eight.values.size() == image.data().size());
  REQUIRE(sixteen.values.size() == image.data().size());
  int wrong = 0;
  for (std::size_t i = 0; i < image.data().size(); ++i) {
    if (eight.values[i] != curve.to_8bit(image.data()[i])) ++wrong;
    if (sixteen.values[i] != curve.to_16bit(image.data()[i])) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("png: holds the picture and its colour space and nothing of the time", "[png]") {
  CHECK(chunks(encode(make_ramp(9, 9), Format::png8, 1)) == "IHDR sRGB IDAT IEND");
  CHECK(chunks(encode(make_ramp(9, 9), Format::png16, 1)) == "IHDR sRGB IDAT IEND");
}

TEST_CASE("png: the same picture gives the same bytes", "[png]") {
  CHECK(encode(make_ramp(90, 70), Format::png8, 1) == encode(make_ramp(90, 70), Format::png8, 1));
  CHECK(encode(make_ramp(90, 70), Format::png16, 1) == encode(make_ramp(90, 70), Format::png16, 1));
}

TEST_CASE("png: the widest view there is", "[png]") {
  const Decoded png = decode(encode(Image(65536, 1), Format::png8, 1));
  CHECK(png.width == 65536);
  CHECK(png.height == 1);
}
