#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string>
#include <string_view>

#include "catch.hpp"
#include "project/source_tree.hpp"

namespace {

/// Whether the text names a place of one machine: a home, a scratch or a working folder at the root of the
/// disk.
bool names_a_machine(std::string_view text) {
  // In two parts each, so that this file does not name one.
  static const std::array<std::string, 5> places{
      "/wo"
      "rk/",
      "/tm"
      "p/",
      "/ho"
      "me/",
      "/ro"
      "ot/",
      "/mn"
      "t/"};
  return std::ranges::any_of(places, [text](const std::string& place) {
    for (std::size_t at = text.find(place); at != std::string_view::npos; at = text.find(place, at + 1)) {
      const char before = at == 0 ? ' ' : text[at - 1];
      const bool inside_a_path = std::isalnum(static_cast<unsigned char>(before)) != 0 ||
                                 std::string_view("._-/}$").find(before) != std::string_view::npos;
      if (!inside_a_path) return true;
    }
    return false;
  });
}

std::string text_of(std::string_view path) {
  for (const TreeFile& file : source_tree()) {
    if (file.path == path) return file.text;
  }
  return {};
}

}  // namespace

TEST_CASE("repository: no file names a place of one machine", "[project]") {
  for (const TreeFile& file : source_tree()) {
    CAPTURE(file.path);
    CHECK_FALSE(names_a_machine(file.text));
  }
}

TEST_CASE("repository: a place of one machine is found, and a part of another path is none", "[project]") {
  const std::string place = std::string("/ho") + "me/";
  CHECK(names_a_machine("see " + place + "me/x"));
  CHECK(names_a_machine(place + "x"));
  CHECK(names_a_machine("open(\"" + place + "x\")"));
  CHECK_FALSE(names_a_machine("my" + place + "x"));
  CHECK_FALSE(names_a_machine("./tests" + place + "x"));
}

TEST_CASE("repository: every package that is installed has its reason", "[project]") {
  std::istringstream list(text_of("scripts/packages"));
  const std::string reasons = text_of("docs/dependencies.md");
  int packages = 0;
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with('#')) continue;
    const std::string package = line.substr(line.find(' ') + 1);
    ++packages;
    CAPTURE(package);
    CHECK(reasons.find(package) != std::string::npos);
  }
  CHECK(packages >= 10);
}
