#pragma once
// The picture formats that Lancer writes, and how a file's ending or a word on the command line names one.

#include <optional>
#include <string_view>

namespace lancer::image {

enum class Format {
  png8,       // PNG, 8 bits a channel, sRGB
  png16,      // PNG, 16 bits a channel, sRGB
  ppm,        // binary PPM (P6), 8 bits
  ppm_ascii,  // PPM in decimal text (P3), 8 bits
  pfm,        // 32-bit floats, linear
  exr,        // OpenEXR, 32-bit floats, linear
};

/// The words that format_from_name() knows, for messages and help.
inline constexpr std::string_view k_format_names = "png, png16, ppm, p6, p3, pfm, exr";

/// The endings that format_from_path() knows, for messages and help.
inline constexpr std::string_view k_format_endings = ".png, .ppm, .pfm, .exr";

/// The format that a path's ending asks for, capitals or not: .png is png8 and .ppm is P6. Nothing for any
/// other.
std::optional<Format> format_from_path(std::string_view path);

/// The format of that name; small letters.
std::optional<Format> format_from_name(std::string_view name);

}  // namespace lancer::image
