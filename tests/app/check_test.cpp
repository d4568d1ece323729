#include <csignal>
#include <nlohmann/json.hpp>

#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;
using test::Result;
using test::run_program;

TEST_CASE("check: a script without mistakes is 0 and draws nothing", "[app][check]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "print(1)\nsphere { x, 1 }\n");
  const Result r = run_program({"check", scene});
  CHECK(r.exit_code == 0);
  CHECK(r.out.empty());
  CHECK(r.err == scene + ": fine\n");
  CHECK(f.names() == std::vector<std::string>{"a.scn"});
}

TEST_CASE("check: run lets print through, exactly", "[app][check]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "print(1, \"a\")\nprint()\nprint(\"\\u{1F600}\")\n");
  const Result r = run_program({"check", "--run", scene});
  CHECK(r.exit_code == 0);
  CHECK(r.out == "1 a\n\n\xF0\x9F\x98\x80\n");
}

TEST_CASE("check: what was printed before a mistake stays", "[app][check]") {
  test::Folder f;
  const Result r = run_program({"check", "--run", f.write("a.scn", "print(1)\nsphere { x, 0 }\nprint(2)\n")});
  CHECK(r.exit_code == 1);
  CHECK(r.out == "1\n");
  CHECK_THAT(r.err, ContainsSubstring("error[E013]"));
}

TEST_CASE("check: warns of unused names", "[app][check]") {
  test::Folder f;
  const Result r = run_program({"check", f.write("a.scn", "let a = 1\n")});
  CHECK(r.exit_code == 0);
  CHECK(r.out.empty());
  CHECK_THAT(r.err, ContainsSubstring("warning[W101]"));
  CHECK_THAT(r.err, ContainsSubstring(": fine, with 1 warning\n"));
}

TEST_CASE("check: several files, each with its own verdict", "[app][check]") {
  test::Folder f;
  const std::string good = f.write("a.scn", "sphere { x, 1 }\n"), bad = f.write("b.scn", "sphere { x, 0 }\n");
  CHECK(run_program({"check", good, bad}).exit_code == 1);
  CHECK(run_program({"check", bad, good}).exit_code == 1);
  CHECK(run_program({"check", good, good}).exit_code == 0);
  const Result r = run_program({"check", f.path("no.scn"), bad, good});
  CHECK(r.exit_code == 3);
  CHECK_THAT(r.err, ContainsSubstring("no such file"));
  CHECK_THAT(r.err, ContainsSubstring("error[E013]"));
  CHECK_THAT(r.err, ContainsSubstring(good + ": fine\n"));
}

TEST_CASE("check: messages as JSON, an object a line", "[app][check]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "// \xC3\xA4\nsphere { x,\n  a }  sphere { b, 1 }\n");
  const Result r = run_program({"check", "--format", "json", scene});
  CHECK(r.exit_code == 1);
  CHECK(r.err.empty());
  std::istringstream lines(r.out);
  std::string line;
  std::vector<nlohmann::json> found;
  while (std::getline(lines, line)) found.push_back(nlohmann::json::parse(line));
  REQUIRE(found.size() == 2);
  CHECK(found[0]["file"] == scene);
  CHECK(found[0]["line"] == 3);
  CHECK(found[0]["column"] == 3);
  CHECK(found[0]["end_line"] == 3);
  CHECK(found[0]["end_column"] == 4);
  CHECK(found[0]["severity"] == "error");
  CHECK(found[0]["code"] == "E020");
  CHECK_FALSE(found[0]["message"].get<std::string>().empty());
  CHECK(found[0].contains("help"));
  CHECK(found[1]["column"] == 17);
}

TEST_CASE("check: JSON of a warning, of invalid text, of a missing file, and beside prints", "[app][check]") {
  test::Folder f;
  const Result warning = run_program({"check", "--format", "json", f.write("a.scn", "let a = 1\n")});
  CHECK(warning.exit_code == 0);
  CHECK(nlohmann::json::parse(warning.out)["code"] == "W101");
  const Result invalid = run_program({"check", "--format=json", f.write("b.scn", "let \xFF = 1\n")});
  CHECK(invalid.exit_code == 1);
  CHECK(nlohmann::json::parse(invalid.out.substr(0, invalid.out.find('\n')))["line"] == 1);
  const Result missing = run_program({"check", "--format", "json", f.path("no.scn")});
  CHECK(missing.exit_code == 3);
  CHECK(nlohmann::json::parse(missing.out)["file"] == f.path("no.scn"));
  // Standard output is print's alone.
  const Result both =
      run_program({"check", "--run", "--format", "json", f.write("c.scn", "print(1)\nlet a = 1\n")});
  CHECK(both.out == "1\n");
  CHECK(nlohmann::json::parse(both.err)["code"] == "W101");
}

TEST_CASE("check: include folders", "[app][check]") {
  test::Folder f;
  f.write("lib/m.scn", "let r = 2\n");
  const std::string scene = f.write("scenes/a.scn", "include \"m.scn\"\nprint(r)\n");
  CHECK(run_program({"check", scene}).exit_code == 1);
  CHECK(run_program({"check", "--run", scene, "-I", f.path("lib")}).out == "2\n");
  CHECK(run_program({"check", "--run", "-I", f.path("scenes"), "-I", f.path("lib"), scene}).out == "2\n");
}

TEST_CASE("check: a reader that goes away ends a script that prints for ever", "[app][check]") {
  test::Folder f;
  test::Running running(
      {"check", "--run", "--max-steps", "0", f.write("a.scn", "while true { print(\"y\") }\n")});
  running.wait_for_output();
  running.close_output();
  const Result r = running.wait();
  CHECK(r.exit_code == 3);
  CHECK(r.err == "lancer: cannot write to standard output: Broken pipe\n");
}
