#pragma once
// A host for tests: files in memory, printed lines kept.

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "session/host.hpp"

namespace lancer::test {

class MemoryHost : public session::Host {
 public:
  std::map<std::string, std::string> files;
  std::string printed;

  session::FileText read(const std::string& canonical) override {
    const auto found = files.find(canonical);
    if (found == files.end()) return {session::FileText::Status::missing, {}, "no such file"};
    return {session::FileText::Status::read, found->second, {}};
  }
  std::string canonical(const std::string& path) override {
    if (path.empty() || path == "." || path == "/") return "/";
    const std::string absolute = path.starts_with('/') ? path : "/" + path;
    const auto is_there = [&](const auto& file) {
      return file.first == absolute || file.first.starts_with(absolute + "/");
    };
    return std::any_of(files.begin(), files.end(), is_there) ? absolute : std::string{};
  }
  void print(std::string_view text) override { printed += text; }
};

}  // namespace lancer::test
