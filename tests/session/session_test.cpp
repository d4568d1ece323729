#include "session/session.hpp"

#include <algorithm>
#include <atomic>

#include "catch.hpp"
#include "memory_host.hpp"

using namespace lancer;

namespace {

struct Fixture {
  test::MemoryHost host;
  session::Session session{host};
  session::RunOptions options;

  session::Run run(const std::string& text) {
    host.files["/main.scn"] = text;
    return session.run_file("/main.scn", options);
  }
  /// "file:line:column E040 message" of the first diagnostic.
  std::string first(const session::Run& run) {
    if (run.diagnostics.empty()) return "";
    const Diagnostic& d = run.diagnostics.front();
    const Position at = session.sources()[d.span.file].position(d.span.begin);
    return session.sources()[d.span.file].name() + ":" + std::to_string(at.line) + ":" +
           std::to_string(at.column) + " " + code_name(d.code) + " " + d.message;
  }
};

}  // namespace

TEST_CASE("session: a script becomes a scene and a picture", "[session]") {
  Fixture f;
  const session::Run run = f.run(
      "sphere { <0, 0, 0>, 1  material { ambient 1 } }\nsettings { ambient 1 }\nview { eye <0, 0, 5> look_at "
      "<0, 0, 0> size 9, 9 }");
  REQUIRE(run.outcome == session::Outcome::fine);
  REQUIRE(f.session.scene().spheres.size() == 1);
  tracer::Options options;
  options.samples = 1;
  const tracer::Rendered out = f.session.render(f.session.views().front(), options);
  CHECK(out.image.width() == 9);
  CHECK(out.image.pixel(4, 4)[0] == 1.0F);  // the ball, in full ambient light
  CHECK(out.image.pixel(0, 0)[0] == 0.0F);  // the background
}

TEST_CASE("session: a failed run leaves the scene as it was", "[session]") {
  Fixture f;
  REQUIRE(f.run("sphere { <0, 0, 0>, 1 }").outcome == session::Outcome::fine);
  CHECK(f.run("sphere { <0, 0, 0>, 1 }\nsphere { <0, 0, 0>, -1 }").outcome == session::Outcome::script_wrong);
  CHECK(f.session.scene().spheres.size() == 1);
  CHECK(f.run("nonsense(").outcome == session::Outcome::script_wrong);
  CHECK(f.session.scene().spheres.size() == 1);
}

TEST_CASE("session: included names join the including scope, and a file is read once", "[session][include]") {
  Fixture f;
  f.host.files["/materials.scn"] = "let gold = 7\nprint(\"read\")\n";
  f.host.files["/more.scn"] = "include \"materials.scn\"\nlet silver = gold + 1\n";
  const session::Run run = f.run("include \"more.scn\"\ninclude \"materials.scn\"\nprint(gold, silver)\n");
  CHECK(f.first(run) == "");
  CHECK(f.host.printed == "read\n7 8\n");
}

TEST_CASE("session: a missing include is an error of the script at its path", "[session][include]") {
  Fixture f;
  const session::Run run = f.run("\n  include \"nowhere.scn\"\n");
  CHECK(run.outcome == session::Outcome::script_wrong);
  CHECK(f.first(run) == "/main.scn:2:11 E040 there is no file \"nowhere.scn\"");
}

TEST_CASE("session: files that include each other are a cycle", "[session][include]") {
  Fixture f;
  f.host.files["/a.scn"] = "include \"b.scn\"\n";
  f.host.files["/b.scn"] = "include \"a.scn\"\n";
  CHECK(f.first(f.run("include \"a.scn\"\n")) ==
        "/b.scn:1:9 E041 \"a.scn\" is still being read: files include each other in a circle");
  CHECK(f.first(f.run("include \"main.scn\"\n")) ==
        "/main.scn:1:9 E041 \"main.scn\" is still being read: files include each other in a circle");
}

TEST_CASE("session: a file outside the script's folder is refused, an -I folder allows it",
          "[session][include]") {
  Fixture f;
  f.host.files["/lib/shapes.scn"] = "let r = 2\n";
  f.host.files["/scenes/main.scn"] = "include \"../lib/shapes.scn\"\nprint(r)\n";
  session::Run run = f.session.run_file("/scenes/main.scn", f.options);
  CHECK(f.first(run) ==
        "/scenes/main.scn:1:9 E042 \"../lib/shapes.scn\" lies outside the folders that this script may read");
  f.options.include_folders = {"/lib"};
  run = f.session.run_file("/scenes/main.scn", f.options);
  CHECK(f.first(run) == "");
  f.host.files["/scenes/main.scn"] = "include \"shapes.scn\"\nprint(r)\n";
  CHECK(f.session.run_file("/scenes/main.scn", f.options).outcome == session::Outcome::fine);
  CHECK(f.host.printed == "2\n2\n");
}

TEST_CASE("session: syntax errors and unknown names of all files are told in one run", "[session][include]") {
  Fixture f;
  f.host.files["/a.scn"] = "let = 1\n";
  const session::Run run = f.run("include \"a.scn\"\nprint(nowhere)\nlet b = )\nprint(b)\n");
  std::vector<std::string> codes;
  for (const Diagnostic& d : run.diagnostics) codes.push_back(code_name(d.code));
  std::sort(codes.begin(), codes.end());
  // `b` was lost with its statement: that it is unknown is no mistake of its own.
  CHECK(codes == std::vector<std::string>{"E001", "E001", "E020"});
}

TEST_CASE("session: only whole words of what was not understood are names that it may have made",
          "[session]") {
  Fixture f;
  const session::Run run = f.run("print(a)\nlocation {}\nlet lost = )\nprint(lost)\n");
  REQUIRE(run.diagnostics.size() == 3);
  CHECK(run.diagnostics.back().message == "nothing is called `a` here");
}

TEST_CASE("session: names are not missing where an include was not read", "[session][include]") {
  Fixture f;
  f.host.files["/outside/a.scn"] = "let gold = 1\n";
  for (const std::string include :
       {"include \"none.scn\"", "include \"../outside/a.scn\"", "include none.scn"}) {
    f.host.files["/scenes/main.scn"] = include + "\nprint(gold)\nsilver = gold\n";
    CAPTURE(include);
    CHECK(f.session.run_file("/scenes/main.scn", f.options).diagnostics.size() == 1);
  }
}

TEST_CASE("session: a path with a zero byte in it is no file's", "[session][include]") {
  Fixture f;
  CHECK(code_name(f.run("include \"a\\u{0}.scn\"\n").diagnostics.front().code) == "E040");
  CHECK(f.first(f.run("include \"a\\u{0}.scn\"\n")).find("there is no file") != std::string::npos);
}

TEST_CASE("session: a definition from outside takes the place of the script's own let", "[session][define]") {
  Fixture f;
  f.options.defines = {{"n", "2 + 3"}};
  CHECK(f.first(f.run("let n = 1\nprint(n)\n")) == "");
  CHECK(f.first(f.run("print(n * 2)\n")) == "");
  CHECK(f.host.printed == "5\n10\n");
}

TEST_CASE("session: a definition that is no name and value is refused", "[session][define]") {
  Fixture f;
  f.options.defines = {{"2x", "1"}};
  CHECK(f.run("print(1)").outcome == session::Outcome::define_wrong);
  f.options.defines = {{"x", "1 print(2)"}};
  CHECK(f.run("print(1)").outcome == session::Outcome::define_wrong);
  f.options.defines = {{"x", "("}};
  CHECK(f.run("print(1)").outcome == session::Outcome::define_wrong);
  CHECK(f.host.printed.empty());
}

TEST_CASE("session: an interrupt ends an endless loop", "[session]") {
  Fixture f;
  std::atomic<bool> stop{true};
  f.options.interrupt = &stop;
  f.options.limits.steps = 0;
  CHECK(f.run("while true { }").outcome == session::Outcome::interrupted);
}

TEST_CASE("session: a script that is not there is unreadable", "[session]") {
  Fixture f;
  const session::Run run = f.session.run_file("/none.scn", {});
  CHECK(run.outcome == session::Outcome::unreadable);
  CHECK(run.problem == "cannot read /none.scn: no such file");
}

TEST_CASE("session: views are named by their names or their places", "[session]") {
  Fixture f;
  REQUIRE(f.run("view { eye <0, 0, 5> look_at <0, 0, 0> }\nview \"top\" { eye <0, 5, 0> look -y }\nview { "
                "eye <0, 0, 9> look_at <0, 0, 0> }")
              .outcome == session::Outcome::fine);
  REQUIRE(f.session.views().size() == 3);
  CHECK(f.session.view_name(0) == "view 1");
  CHECK(f.session.view_name(1) == "top");
  CHECK(f.session.view_name(2) == "view 2");
}
