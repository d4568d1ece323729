// Talks with lancer repl: every file under transcripts holds what is typed, behind `> ` and, for further
// lines of an entry, `. `, and between it all that is answered, messages included. With LANCER_RENEW set the
// answers are written anew, to be read before they are kept.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;

namespace {

namespace fs = std::filesystem;

/// Said by the program behind each answer, so that answers are told apart.
const std::string k_mark = "~~ answered ~~";

std::vector<std::string> entries_of(const std::string& transcript) {
  std::vector<std::string> out;
  std::istringstream lines(transcript);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("> ")) out.push_back(line.substr(2));
    if (line.starts_with(". ")) out.back().append("\n").append(line, 2);
  }
  return out;
}

std::string prompted(std::string entry) {
  for (std::size_t at = entry.find('\n'); at != std::string::npos; at = entry.find('\n', at + 3))
    entry.insert(at + 1, ". ");
  return "> " + entry + "\n";
}

/// The transcript as the program answers today.
std::string renewed(const std::string& transcript) {
  const test::Folder folder;
  const std::vector<std::string> entries = entries_of(transcript);
  std::string input;
  for (const std::string& entry : entries) input += entry + "\n\"" + k_mark + "\"\n";
  folder.write("in", input);
  const std::string line =
      "cd '" + folder.root().string() + "' && '" LANCER_PROGRAM "' repl --keep-going <in >out 2>&1";
  REQUIRE(std::system(line.c_str()) != -1);
  std::string answers = folder.read("out");
  std::string out;
  for (const std::string& entry : entries) {
    const std::size_t mark = answers.find(k_mark + "\n");
    out += prompted(entry) + answers.substr(0, mark);
    answers.erase(0, mark == std::string::npos ? mark : mark + k_mark.size() + 1);
  }
  return out + answers;
}

test::Result typed(const std::string& input, std::vector<std::string> options = {},
                   const std::string& folder = {}) {
  test::Setting setting;
  setting.input = input;
  setting.folder = folder;
  options.insert(options.begin(), "repl");
  return test::run_program(options, setting);
}

std::string text_of(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

}  // namespace

TEST_CASE("repl: every transcript is answered as it says", "[repl]") {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(LANCER_TRANSCRIPTS)) all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  REQUIRE(all.size() >= 5);
  for (const fs::path& path : all) {
    INFO(path.filename().string());
    const std::string wanted = text_of(path);
    const std::string got = renewed(wanted);
    if (std::getenv("LANCER_RENEW") != nullptr) std::ofstream(path, std::ios::binary) << got;
    CHECK(got == wanted);
  }
}

TEST_CASE("repl: the walk-through in the documentation is what is answered", "[repl]") {
  const std::string page = text_of(LANCER_REPL_PAGE);
  const std::string fence = "```repl\n";
  std::string talk;
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    talk += page.substr(begin, page.find("```", begin) - begin);
  }
  REQUIRE(entries_of(talk).size() > 10);
  CHECK(renewed(talk) == talk);
}

TEST_CASE("repl: a transcript that is wrong about itself is found", "[repl]") {
  CHECK(renewed("> 1 + 1\n3\n") == "> 1 + 1\n2\n");
}

TEST_CASE("repl: without a terminal the first error ends it", "[repl]") {
  const test::Result r = typed("print(1)\nlet a = b\nprint(2)\n");
  CHECK(r.exit_code == 1);
  CHECK(r.out == "1\n");
  CHECK_THAT(r.err, ContainsSubstring("nothing is called `b` here"));
  const test::Result on = typed("print(1)\nlet a = b\nprint(2)\n", {"--keep-going"});
  CHECK(on.exit_code == 1);
  CHECK(on.out == "1\n2\n");
  CHECK(typed("1\n:quit\nnothing").exit_code == 0);
}

TEST_CASE("repl: an entry that the input ends within is a mistake", "[repl]") {
  const test::Result r = typed("sphere {");
  CHECK(r.exit_code == 1);
  CHECK_THAT(r.err, ContainsSubstring("this `{` is never closed"));
}

TEST_CASE("repl: what is saved is drawn with the same bytes", "[repl]") {
  const test::Folder folder;
  const std::string input =
      "// a ring\nlet n = 5\nfor i in 0..n { sphere \"s {i}\" { <i - 2, 0, 0>, 0.4 } }\n"
      "light { at <2, 5, 4> }\nview \"v\" { eye <0, 1, 6> look_at <0, 0, 0> size 40, 30 }\n"
      "modify \"s 2\" { material { diffuse orange } }\nlet n = 4\n:delete \"s 0\"\n:save a.scn\n:render "
      "mine.ppm\n";
  const test::Result r = typed(input, {}, folder.root().string());
  REQUIRE(r.exit_code == 0);
  CHECK_THAT(folder.read("a.scn"), ContainsSubstring("// a ring\nlet n = 4\nfor i in 0..n {"));
  REQUIRE(test::run_program({"render", folder.path("a.scn"), "-o", folder.path("again.ppm")}).exit_code == 0);
  CHECK(folder.read("mine.ppm") == folder.read("again.ppm"));
}
