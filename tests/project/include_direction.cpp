#include "project/include_direction.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <fmt/core.h>
#include <optional>

namespace {

struct Room {
  std::string_view name;
  std::vector<std::string_view> may_include;  // beginnings of paths
};

const std::vector<Room>& rooms() {
  static const std::vector<Room> all{
      {"base", {"base/"}},
      {"scene", {"scene/", "base/"}},
      {"image", {"image/", "base/"}},
      {"lang", {"lang/", "base/", "scene/"}},
      {"grammar", {"grammar/", "base/", "lang/ast.hpp", "lang/keywords.hpp"}},
      {"tracer", {"tracer/", "base/", "scene/", "image/"}},
      {"session", {"session/", "base/", "scene/", "image/", "lang/", "grammar/", "tracer/"}},
      {"app", {"app/", "session/", "image/", "base/", "scene/", "tracer/options.hpp"}},
  };
  return all;
}

/// Libraries that are the business of one room, and output, which is the app's.
struct Guarded {
  std::string_view header;  // the beginning of its path
  std::string_view room;
};
constexpr std::array<Guarded, 8> k_guarded{{{"tao/", "grammar"},
                                            {"CLI/", "app"},
                                            {"nlohmann/", "app"},
                                            {"iostream", "app"},
                                            {"png.h", "image"},
                                            {"Imf", "image"},
                                            {"tbb/", "tracer"},
                                            {"oneapi/", "tracer"}}};

const Room* find_room(std::string_view name) {
  const auto found = std::ranges::find(rooms(), name, &Room::name);
  return found == rooms().end() ? nullptr : &*found;
}

bool starts_with_any(std::string_view path, const std::vector<std::string_view>& beginnings) {
  return std::ranges::any_of(beginnings, [path](std::string_view b) { return path.starts_with(b); });
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  return text;
}

/// The path that a line includes, if it is an include.
std::optional<std::string_view> included_path(std::string_view line) {
  line = without_blanks(line);
  if (!line.starts_with('#')) return std::nullopt;
  line = without_blanks(line.substr(1));
  constexpr std::string_view word = "include";
  if (!line.starts_with(word)) return std::nullopt;
  line = without_blanks(line.substr(word.size()));
  const std::size_t end = line.find_first_of("\">", 1);
  if (line.empty() || end == std::string_view::npos) return std::nullopt;
  return line.substr(1, end - 1);
}

bool is_forbidden(const Room& room, std::string_view path) {
  if (path.find("..") != std::string_view::npos) return true;
  const bool is_ours = find_room(path.substr(0, path.find('/'))) != nullptr;
  if (is_ours) return !starts_with_any(path, room.may_include);
  return std::ranges::any_of(
      k_guarded, [&](const Guarded& g) { return path.starts_with(g.header) && room.name != g.room; });
}

}  // namespace

std::string room_of(std::string_view path) {
  if (path.starts_with("src/")) path.remove_prefix(4);
  const std::string_view first = path.substr(0, path.find('/'));
  return find_room(first) != nullptr ? std::string(first) : std::string();
}

std::vector<std::string> forbidden_includes(std::string_view room_name, std::string_view text) {
  const Room* room = find_room(room_name);
  if (room == nullptr) return {};
  std::vector<std::string> found;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    const std::optional<std::string_view> path = included_path(text.substr(0, end + 1));
    if (path && is_forbidden(*room, *path)) found.push_back(fmt::format("line {}: {}", number, *path));
    text.remove_prefix(end + 1);
  }
  return found;
}
