// Runs every script under tests/scripts and holds it to what its comments say.

#include <algorithm>
#include <filesystem>

#include "catch.hpp"
#include "folder_host.hpp"
#include "scripts/expectations.hpp"
#include "session/session.hpp"

namespace {

namespace fs = std::filesystem;
using namespace lancer;

std::vector<fs::path> cases(const fs::path& root) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const bool included = entry.path().parent_path().filename() == "included";
    if (entry.path().extension() == ".scn" && !included) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("every script case gives exactly what its comments say", "[scripts]") {
  const fs::path root = LANCER_SCRIPTS_FOLDER;
  const std::vector<fs::path> all = cases(root);
  REQUIRE(all.size() > 50);
  for (const fs::path& path : all) {
    test::FolderHost host;
    session::Session session(host);
    const session::Run run = session.run_file(path.string(), {});
    const std::string text = host.read(path.string()).text;
    INFO(fs::relative(path, root).string());
    CHECK(test::differences(test::parse_expectations(text), run.diagnostics, session.sources(),
                            host.printed) == "");
  }
}

TEST_CASE("a script case that is wrong about itself is found", "[scripts]") {
  const std::string text = "print(1)  //~ prints 2\nlet a = 3  //~ error E001: nothing of the kind\n";
  SourceMap sources;
  sources.add("x", text);
  const std::string out = test::differences(test::parse_expectations(text), {}, sources, "1\n");
  CHECK_THAT(out, ContainsSubstring("missing: line 2: error E001"));
  CHECK_THAT(out, ContainsSubstring("instead of:\n2"));
}
