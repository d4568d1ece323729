#pragma once
// A host for tests: files from the disk, printed lines kept.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "session/host.hpp"

namespace lancer::test {

class FolderHost : public session::Host {
 public:
  std::string printed;

  session::FileText read(const std::string& canonical) override {
    std::ifstream in(canonical, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return {session::FileText::Status::read, text.str(), {}};
  }
  std::string canonical(const std::string& path) override {
    std::error_code problem;
    const std::filesystem::path out = std::filesystem::canonical(path, problem);
    return problem ? std::string{} : out.string();
  }
  void print(std::string_view text) override { printed += text; }
};

}  // namespace lancer::test
