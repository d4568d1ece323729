#include "image/format.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace lancer::image {

namespace {

struct Named {
  std::string_view name;
  Format format;
};

constexpr std::array<Named, 4> k_endings{
    {{"png", Format::png8}, {"ppm", Format::ppm}, {"pfm", Format::pfm}, {"exr", Format::exr}}};
constexpr std::array<Named, 7> k_names{{{"png", Format::png8},
                                        {"png16", Format::png16},
                                        {"ppm", Format::ppm},
                                        {"p6", Format::ppm},
                                        {"p3", Format::ppm_ascii},
                                        {"pfm", Format::pfm},
                                        {"exr", Format::exr}}};

std::optional<Format> find(std::span<const Named> table, std::string_view name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [name](const Named& n) { return n.name == name; });
  if (found == table.end()) return std::nullopt;
  return found->format;
}

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::optional<Format> format_from_path(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::size_t dot = file.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::string ending(file.substr(dot + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(), small_letter);
  return find(k_endings, ending);
}

std::optional<Format> format_from_name(std::string_view name) { return find(k_names, name); }

}  // namespace lancer::image
