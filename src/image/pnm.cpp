// The portable any-maps: PPM as text and bytes, PFM.

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <fmt/core.h>
#include <string_view>

#include "image/codecs.hpp"

namespace lancer::image {

namespace {

constexpr std::size_t k_longest_line = 70;

std::string header(const char* magic, const Image& image, const char* maximum) {
  return fmt::format("{}\n{} {}\n{}\n", magic, image.width(), image.height(), maximum);
}

/// "255 0 12": at most 11 characters.
class PixelText {
 public:
  PixelText(std::span<const float, 3> rgb, const ToneCurve& curve) {
    for (const float light : rgb) {
      if (end_ != text_.data()) *end_++ = ' ';
      end_ = std::to_chars(end_, text_.data() + text_.size(), int{curve.to_8bit(light)}).ptr;
    }
  }
  std::string_view view() const { return {text_.data(), static_cast<std::size_t>(end_ - text_.data())}; }

 private:
  std::array<char, 12> text_{};
  char* end_ = text_.data();
};

void append_row(std::string& out, const Image& image, int y, const ToneCurve& curve) {
  std::size_t line = 0;
  for (int x = 0; x < image.width(); ++x) {
    const PixelText text(image.pixel(x, y), curve);
    const std::string_view pixel = text.view();
    const bool fits = line + 1 + pixel.size() <= k_longest_line;
    if (x > 0) out += fits ? ' ' : '\n';
    line = x > 0 && fits ? line + 1 + pixel.size() : pixel.size();
    out += pixel;
  }
  out += '\n';
}

void append_little_endian(std::string& out, std::span<const float> row) {
  if constexpr (std::endian::native == std::endian::little) {
    out.append(reinterpret_cast<const char*>(row.data()), row.size_bytes());
  } else {
    for (const float value : row) {
      const auto bits = std::bit_cast<std::uint32_t>(value);
      for (unsigned shift = 0; shift < 32; shift += 8) out += static_cast<char>((bits >> shift) & 0xffU);
    }
  }
}

}  // namespace

std::string encode_ppm(const Image& image, const ToneCurve& curve) {
  std::string out = header("P6", image, "255");
  const std::size_t first = out.size();
  out.resize(first + image.data().size());
  char* to = out.data() + first;
  for (const float light : image.data()) *to++ = static_cast<char>(curve.to_8bit(light));
  return out;
}

std::string encode_ppm_ascii(const Image& image, const ToneCurve& curve) {
  std::string out = header("P3", image, "255");
  // Four characters a value at most, blank or line end included; pages that are not written to take no
  // memory.
  out.reserve(out.size() + image.data().size() * 4);
  for (int y = 0; y < image.height(); ++y) append_row(out, image, y, curve);
  return out;
}

std::string encode_pfm(const Image& image) {
  std::string out = header("PF", image, "-1.0");
  out.reserve(out.size() + image.data().size() * sizeof(float));
  for (int y = image.height() - 1; y >= 0; --y) append_little_endian(out, image.row(y));
  return out;
}

}  // namespace lancer::image
