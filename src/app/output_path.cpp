#include "app/output_path.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace lancer::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_longest_name = 100;  // bytes of a view's name in that of a file

bool is_safe(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         byte >= 0x80;
}

std::string safe_name(std::string name) {
  if (name.size() > k_longest_name) {
    std::size_t end = k_longest_name;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80)
      --end;  // not within a character
    name.resize(end);
  }
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_safe(c); }, '-');
  return name;
}

}  // namespace

std::string ending_of(image::Format format) {
  switch (format) {
    case image::Format::png8:
    case image::Format::png16: return ".png";
    case image::Format::ppm:
    case image::Format::ppm_ascii: return ".ppm";
    case image::Format::pfm: return ".pfm";
    case image::Format::exr: return ".exr";
  }
  return "";
}

std::string beside_script(const std::string& script, image::Format format) {
  return fs::path(script).replace_extension(ending_of(format)).string();
}

std::vector<std::string> paths_of_views(const std::string& path, const std::vector<std::string>& views) {
  const fs::path whole(path);
  const std::string ending = whole.extension().string();
  const std::string stem = path.substr(0, path.size() - ending.size());
  std::vector<std::string> out;
  for (const std::string& view : views) {
    const std::string base = fmt::format("{}-{}", stem, safe_name(view));
    std::string candidate = base + ending;
    for (int i = 2; std::find(out.begin(), out.end(), candidate) != out.end(); ++i) {
      candidate = fmt::format("{}-{}{}", base, i, ending);
    }
    out.push_back(std::move(candidate));
  }
  return out;
}

}  // namespace lancer::app
