#include <nlohmann/json.hpp>

#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;
using test::Result;
using test::run_program;

namespace {

const std::string k_scene =
    "let n = 1.5\n"
    "sphere \"ball\" { <0, 0, 0>, 1  material { diffuse 0.2  transmission 0.8  ior n } }\n"
    "plane { y, -1 }\n"
    "light \"lamp\" { at <3, 3, 3>  color 0.5 }\n"
    "view \"front\" { eye <0, 0, 5> look_at <0, 0, 0> size 12, 8 }\n"
    "view \"top\" { eye <0, 5, 0> look_at <0, 0, 0> size 20, 10 }\n";

/// What the JSON says of a skip.
nlohmann::json skip(const nlohmann::json& report, const std::string& name) {
  for (const auto& one : report["skips"]) {
    if (one["name"] == name) return one;
  }
  return {};
}

}  // namespace

TEST_CASE("plan: what is done, what is left out, and why", "[app][plan]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const Result r = run_program({"plan", scene, "--no-skip=tree", "--samples", "16"});
  CHECK(r.exit_code == 0);
  CHECK(r.err.empty());
  CHECK(r.out == "view `front` of " + scene + R"(: 12 x 8 pixels, 16 samples each

  shapes       1 sphere, 1 plane
  materials    2 worn
  lights       1 light
  other views  `top`: not drawn
  structure    a tree of 2
  primary      1536 rays
  onward rays  reflected and refracted, to depth 8
  shadow rays  what comes through everything in the way

left out
  patterns     patterned colours that no term needs, as nothing wears one
  single-rays  tracing each ray by itself, as rays of neighbouring pixels are traced together

left out where met
  dark-lights  shadow rays to lights that are black, behind the surface or aimed elsewhere
  zero-terms   lights at points that send none of them back

needed
  any-hit      what lies behind the first surface in the way of a light, as light may come through `ball`
  faint-lights shadow rays to lights too weak to show, as no error is asked for
  faint-rays   reflected and refracted rays too weak to show, as no error is asked for
  media        lists of the solids that a ray is inside of, as `ball` may bend light
  recursion    rays that go on from a surface, as `ball` may reflect or let light through
  shadow-rays  shadow rays, as `ball` and plane 1 may stand between a light and a surface

not needed, and done all the same for --no-skip
  tree         a tree of boxes, as 2 things are asked one by one
)");
}

TEST_CASE("plan: to an error, the first look is told, and what may be too faint", "[app][plan]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const Result r = run_program({"plan", scene, "--error", "0.05"});
  CHECK(run_program({"plan", scene}).out == r.out);
  CHECK(r.out.find("view `front` of " + scene + ": 12 x 8 pixels, each to an error of 0.05\n") == 0);
  // 15 x 11 corners and 14 x 10 pixels.
  CHECK(r.out.find(
            "  primary      305 rays for a first look, and more in the pixels that it leaves in doubt\n") !=
        std::string::npos);
  CHECK(r.out.find("  faint-rays   ") > r.out.find("left out where met"));
  CHECK(r.out.find("  faint-rays   ") < r.out.find("\nneeded\n"));
  const auto report = nlohmann::json::parse(run_program({"plan", scene, "--json", "--error", "0.05"}).out);
  CHECK(report["samples"] == 0);
  CHECK(report["error"] == 0.05);
}

TEST_CASE("plan: of the view, size and variables that are asked for, as JSON", "[app][plan]") {
  test::Folder f;
  const Result r = run_program({"plan", f.write("a.scn", k_scene), "--json", "--view", "top", "-D", "n=1",
                                "--samples", "3", "--region", "10,5,40,9"});
  CHECK(r.exit_code == 0);
  const auto report = nlohmann::json::parse(r.out);
  CHECK(report["view"] == "top");
  CHECK(report["other_views"] == nlohmann::json{"front"});
  CHECK(report["width"] == 20);
  CHECK(report["primary_rays"] == 10 * 4 * 3);
  CHECK(report["structure"] == "list");
  CHECK(report["shapes"]["plane"] == 1);
  CHECK(report["skips"].size() == 11);
  CHECK(skip(report, "media")["verdict"] == "skipped");
  CHECK(skip(report, "media")["why"] == "all refractive indices are the same");
  CHECK(skip(report, "recursion")["verdict"] == "needed");
  CHECK(skip(report, "dark-lights")["verdict"] == "as met");
}

TEST_CASE("plan: what is wrong is said as render says it", "[app][plan]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const Result view = run_program({"plan", scene, "--view", "font"});
  CHECK(view.exit_code == 2);
  CHECK(view.err.find("lancer: there is no view `font` (did you mean `front`?)") == 0);
  CHECK(run_program({"plan", f.path("no.scn")}).exit_code == 3);
  CHECK(run_program({"plan", f.write("b.scn", "sphere {")}).exit_code == 1);
  CHECK(run_program({"plan", "-"}, {"sphere { <0, 0, 0>, 1 }\n", {}, false, {}}).exit_code == 0);
  CHECK(f.names() == std::vector<std::string>{"a.scn", "b.scn"});
}
