// The documentation keeps its word: its scripts run, its commands succeed, its pictures are there.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdlib.h>
#include <string>
#include <vector>

#include "catch.hpp"
#include "folder_host.hpp"
#include "memory_host.hpp"
#include "session/session.hpp"

namespace {

namespace fs = std::filesystem;
using namespace lancer;

const fs::path k_root = LANCER_ROOT;

std::vector<fs::path> pages() {
  std::vector<fs::path> out{k_root / "README.md", k_root / "CONTRIBUTING.md"};
  for (const auto& entry : fs::recursive_directory_iterator(k_root / "docs")) {
    if (entry.path().extension() == ".md") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string read(const fs::path& path) {
  test::FolderHost host;
  return host.read(path.string()).text;
}

/// The insides of the fenced blocks of a language.
std::vector<std::string> blocks(const std::string& page, const std::string& language) {
  std::vector<std::string> out;
  const std::string fence = "```" + language + "\n";
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    out.push_back(page.substr(begin, page.find("\n```", begin) + 1 - begin));
  }
  return out;
}

/// The lines that begin with `$ `, without it.
std::vector<std::string> commands(const std::string& block) {
  std::vector<std::string> out;
  std::istringstream lines(block);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("$ ")) out.push_back(line.substr(2));
  }
  return out;
}

/// A folder of its own with the samples in it.
class Workshop {
 public:
  Workshop() {
    std::string pattern = (fs::temp_directory_path() / "lancer-docs-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    fs::copy(k_root / "samples", folder_ / "samples");
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  int run(const std::string& command) const {
    const std::string line = "cd '" + folder_.string() +
                             "' && PATH='" LANCER_PROGRAM_FOLDER "':\"$PATH\" && " + command + " >out 2>err";
    return std::system(line.c_str());
  }
  std::string errors() const { return read(folder_ / "err"); }

 private:
  fs::path folder_;
};

}  // namespace

TEST_CASE("every script in the documentation runs without a word", "[docs]") {
  std::size_t count = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& script : blocks(read(page), "scn")) {
      INFO(page.filename().string() << ":\n" << script);
      test::MemoryHost host;
      session::Session session(host);
      const session::Run run = session.run_text("script", script, "", {});
      std::vector<Diagnostic> problems = run.diagnostics;
      std::erase_if(problems, [](const Diagnostic& d) { return d.code == Code::unused; });
      CHECK(to_text(problems, session.sources()) == "");
      ++count;
    }
  }
  CHECK(count >= 4);
}

TEST_CASE("every command in the documentation succeeds", "[docs]") {
  const Workshop workshop;
  std::size_t count = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& block : blocks(read(page), "console")) {
      for (const std::string& command : commands(block)) {
        INFO(page.filename().string() << ": " << command);
        const bool succeeded = workshop.run(command) == 0;
        INFO(workshop.errors());
        CHECK(succeeded);
        ++count;
      }
    }
  }
  CHECK(count >= 10);
}

TEST_CASE("every sample is shown in the documentation, with its picture", "[docs]") {
  const std::string gallery = read(k_root / "docs" / "samples.md");
  for (const auto& entry : fs::directory_iterator(k_root / "samples")) {
    const std::string name = entry.path().stem().string();
    INFO(name);
    CHECK(gallery.find("../samples/" + name + ".scn") != std::string::npos);
    CHECK(gallery.find("pictures/" + name + ".png") != std::string::npos);
    CHECK(fs::exists(k_root / "docs" / "pictures" / (name + ".png")));
  }
}

TEST_CASE("no link within the documentation leads nowhere", "[docs]") {
  for (const fs::path& page : pages()) {
    const std::string text = read(page);
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
      const std::string target = text.substr(at + 2, text.find_first_of(")#", at + 2) - at - 2);
      if (target.empty() || target.find("://") != std::string::npos || target.find(' ') != std::string::npos)
        continue;
      INFO(page.filename().string() << ": " << target);
      CHECK(fs::exists(page.parent_path() / target));
    }
  }
}
