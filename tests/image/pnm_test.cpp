#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

#include "catch.hpp"
#include "image/encode.hpp"
#include "pictures.hpp"

using namespace lancer::image;
using namespace std::string_literals;

namespace {

const float k_nan = std::numeric_limits<float>::quiet_NaN();

/// The longest line's characters, without its end.
std::size_t longest_line(const std::string& text) {
  std::istringstream in(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(in, line);) longest = std::max(longest, line.size());
  return longest;
}

/// A float from four bytes, the lowest first.
float little_endian_float(const std::string& bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return std::bit_cast<float>(bits);
}

}  // namespace

TEST_CASE("ppm: the bytes of a small picture", "[ppm]") {
  // 0.5 is 188 (hexadecimal BC); see the tests of the tone curve.
  const Image image = make_image(2, 1, {0, 0.5F, 1, 2, -1, k_nan});
  CHECK(encode(image, Format::ppm, 1) == "P6\n2 1\n255\n\x00\xBC\xFF\xFF\x00\x00"s);
}

TEST_CASE("ppm: rows run from the top, pixels from the left", "[ppm]") {
  const Image image = make_image(2, 2, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
  CHECK(encode(image, Format::ppm, 1) == "P6\n2 2\n255\n\xFF\x00\x00\x00\xFF\x00\x00\x00\xFF\xFF\xFF\xFF"s);
}

TEST_CASE("ppm: the exposure counts", "[ppm]") {
  CHECK(encode(make_image(1, 1, {0.25F, 1, 0}), Format::ppm, 2) == "P6\n1 1\n255\n\xBC\xFF\x00"s);
}

TEST_CASE("ppm as text: the bytes of a small picture", "[ppm]") {
  const Image image = make_image(2, 2, {0, 0.5F, 1, 2, -1, k_nan, 0.25F, 0, 0, 1, 1, 1});
  CHECK(encode(image, Format::ppm_ascii, 1) == "P3\n2 2\n255\n0 188 255 255 0 0\n137 0 0 255 255 255\n");
}

TEST_CASE("ppm as text: a line holds whole pixels, as many as 70 characters do", "[ppm]") {
  // "255 255 255" is 11 characters: five of them with four blanks are 59, a sixth would make 71.
  Image white(7, 1);
  for (int x = 0; x < 7; ++x) std::ranges::fill(white.pixel(x, 0), 1.0F);
  const std::string pixel = "255 255 255";
  CHECK(encode(white, Format::ppm_ascii, 1) == "P3\n7 1\n255\n" + pixel + " " + pixel + " " + pixel + " " +
                                                   pixel + " " + pixel + "\n" + pixel + " " + pixel + "\n");
  // "0 0 0" is 5 characters: twelve of them with eleven blanks are 71, so eleven fit.
  const std::string black = encode(Image(12, 1), Format::ppm_ascii, 1);
  CHECK(std::ranges::count(black, '\n') == 3 + 2);
  CHECK(longest_line(black) == 65);
  CHECK(longest_line(encode(make_ramp(37, 9), Format::ppm_ascii, 1)) <= 70);
}

TEST_CASE("ppm as text: a line of exactly 70 characters is not broken", "[ppm]") {
  // Five pixels "255 255 255" and four blanks are 59; one blank and "255 255 0" make 69, "255 255 10" 70.
  // 10 / 255 is 0.0392157, on the straight part: 0.0392157 / 12.92 = 0.00303527.
  Image image(6, 1);
  for (int x = 0; x < 6; ++x) std::ranges::fill(image.pixel(x, 0), 1.0F);
  image.pixel(5, 0)[2] = 0.00303527F;
  const std::string text = encode(image, Format::ppm_ascii, 1);
  CHECK(longest_line(text) == 70);
  CHECK(std::ranges::count(text, '\n') == 4);
}

TEST_CASE("ppm as text: read back, it is what the bytes of P6 say", "[ppm]") {
  const Image image = make_ramp(13, 5);
  std::istringstream in(encode(image, Format::ppm_ascii, 1));
  std::string magic;
  int width = 0, height = 0, maximum = 0;
  in >> magic >> width >> height >> maximum;
  REQUIRE((magic == "P3" && width == 13 && height == 5 && maximum == 255));
  std::string bytes;
  for (int value = 0; in >> value;) bytes += static_cast<char>(value);
  const std::string binary = encode(image, Format::ppm, 1);
  CHECK(bytes == binary.substr(binary.size() - 13 * 5 * 3));
}

TEST_CASE("pfm: the bytes of a small picture", "[pfm]") {
  // 1 is 3F800000, 0.5 is 3F000000, -2 is C0000000, 0.25 is 3E800000; the lower row comes first.
  const Image image = make_image(1, 2, {1, 0.5F, -2, 0.25F, 0, 1});
  CHECK(encode(image, Format::pfm, 1) ==
        "PF\n1 2\n-1.0\n"
        "\x00\x00\x80\x3E\x00\x00\x00\x00\x00\x00\x80\x3F"
        "\x00\x00\x80\x3F\x00\x00\x00\x3F\x00\x00\x00\xC0"s);
}

TEST_CASE("pfm: every value comes back bit by bit, whatever the exposure", "[pfm]") {
  const Image image = make_ramp(5, 3);
  const std::string bytes = encode(image, Format::pfm, 8);
  const std::size_t start = bytes.size() - 5 * 3 * 3 * 4;
  CHECK(bytes.substr(0, start) == "PF\n5 3\n-1.0\n");
  for (int y = 0; y < 3; ++y) {
    for (std::size_t i = 0; i < 15; ++i) {
      const std::size_t row = static_cast<std::size_t>(2 - y) * 15 * 4;
      CHECK(little_endian_float(bytes, start + row + 4 * i) == image.row(y)[i]);
    }
  }
}
