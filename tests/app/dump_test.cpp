#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;
using test::Result;
using test::run_program;

TEST_CASE("dump: the scene", "[app][dump]") {
  test::Folder f;
  const Result r = run_program(
      {"dump", "--scene", f.write("a.scn", "let n = 1\nprint(n)\nsphere \"ball\" { x, n }\n"), "-D", "n=3"});
  CHECK(r.exit_code == 0);
  CHECK(r.err.empty());
  CHECK_THAT(r.out, ContainsSubstring(
                        "\nsphere \"ball\" center <1, 0, 0> radius 3 material 0 transform 0 shadow true\n"));
}

TEST_CASE("dump: the tree of a script, whose mistakes beyond syntax do not matter", "[app][dump]") {
  test::Folder f;
  const Result r = run_program({"dump", "--ast", f.write("a.scn", "include \"no.scn\"\nlet a = b\n")});
  CHECK(r.exit_code == 0);
  CHECK_THAT(r.out, ContainsSubstring("let a"));
  const Result wrong = run_program({"dump", "--ast", f.write("b.scn", "let = 1\n")});
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.out.empty());
  CHECK(run_program({"dump", "--ast", f.path("no.scn")}).exit_code == 3);
}

TEST_CASE("dump: from standard input", "[app][dump]") {
  const Result r = run_program({"dump", "--ast", "-"}, {"let a = 1\n", {}, false, {}});
  CHECK(r.exit_code == 0);
  CHECK_THAT(r.out, ContainsSubstring("let a"));
  const Result scene = run_program({"dump", "-", "--scene"}, {"sphere { x, 0 }\n", {}, false, {}});
  CHECK(scene.exit_code == 1);
  CHECK(scene.err.find("<stdin>:1:13: error[E013]") == 0);
}
