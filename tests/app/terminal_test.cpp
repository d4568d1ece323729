#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;
using test::Result;
using test::run_on_terminal;

namespace {
const std::string k_scene = "sphere { <0, 0, 0>, 1 }\nview { eye <0, 0, 5> look_at <0, 0, 0> size 8, 8 }\n";
}

TEST_CASE("terminal: a picture is not for a terminal", "[app][terminal]") {
  test::Folder f;
  const Result r = run_on_terminal({f.write("a.scn", k_scene), "-o", "-"}, true);
  CHECK(r.exit_code == 2);
  CHECK_THAT(r.err, ContainsSubstring("lancer: a picture is not for a terminal"));
}

TEST_CASE("terminal: progress is shown on one, and only there", "[app][terminal]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const Result shown = run_on_terminal({scene}, false);
  CHECK(shown.exit_code == 0);
  CHECK_THAT(shown.err, ContainsSubstring(" %"));
  CHECK_THAT(shown.err, ContainsSubstring("view 1 ["));
  const Result quiet = run_on_terminal({scene, "--quiet"}, false);
  CHECK(quiet.err.empty());
  const Result dumb = run_on_terminal({scene}, false, {"TERM=dumb"});
  CHECK(dumb.err.find('\r') == dumb.err.find("\r\n"));
}

TEST_CASE("terminal: messages have colours there unless NO_COLOR is set", "[app][terminal]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "sphere { x, 0 }\n");
  CHECK_THAT(run_on_terminal({"check", scene}, false).err, ContainsSubstring("\x1b["));
  CHECK(run_on_terminal({"check", scene}, false, {"NO_COLOR=1"}).err.find('\x1b') == std::string::npos);
  CHECK(run_on_terminal({"check", scene}, false, {"TERM=dumb"}).err.find('\x1b') == std::string::npos);
}
