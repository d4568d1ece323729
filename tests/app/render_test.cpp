#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;
using test::Result;
using test::run_program;
using Names = std::vector<std::string>;

namespace {

const std::string k_scene =
    "sphere { <0, 0, 0>, 1 }\nlight { at <3, 3, 3> }\n"
    "view \"front\" { eye <0, 0, 5> look_at <0, 0, 0> size 12, 8 }\n"
    "view \"top\" { eye <0, 5, 0> look_at <0, 0, 0> size 12, 8 }\n";

const std::string k_png = "\x89PNG";

}  // namespace

TEST_CASE("render: a picture beside the script, a line of what was written, a note of other views",
          "[app][render]") {
  test::Folder f;
  const Result r = run_program({"render", f.write("a.scn", k_scene)});
  CHECK(r.exit_code == 0);
  CHECK(r.out.empty());
  CHECK(f.names() == Names{"a.png", "a.scn"});
  CHECK(f.read("a.png").find(k_png) == 0);
  CHECK_THAT(r.err, ContainsSubstring("wrote " + f.path("a.png") + ", 12 x 8, in "));
  CHECK_THAT(
      r.err,
      ContainsSubstring(
          "note: this is view `front` of 2: `front`, `top`; --view NAME or --all-views draws others\n"));
  CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 2);
  CHECK(r.err.find('\r') == std::string::npos);
}

TEST_CASE("render: the word may be left out, and quiet says nothing", "[app][render]") {
  test::Folder f;
  const Result r = run_program({f.write("a.scn", k_scene), "--quiet"});
  CHECK(r.exit_code == 0);
  CHECK(r.out.empty());
  CHECK(r.err.empty());
  CHECK(f.has("a.png"));
}

TEST_CASE("render: options may stand before the file", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  CHECK(run_program({"--quiet", "-D", "unused=1", "--view", "top", "-I", ".", scene, "-o", f.path("b.ppm")})
            .exit_code == 0);
  CHECK(f.read("b.ppm").find("P6\n12 8\n255\n") == 0);
}

TEST_CASE("render: the format goes by the ending, or by its name", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const auto begins = [&](const std::string& file, std::vector<std::string> more, const std::string& with) {
    std::vector<std::string> arguments{scene, "--quiet", "--samples", "1", "-o", f.path(file)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    CHECK(run_program(arguments).exit_code == 0);
    CHECK(f.read(file).substr(0, with.size()) == with);
  };
  begins("a.png", {}, k_png);
  begins("a.ppm", {}, "P6\n");
  begins("a.pfm", {}, "PF\n");
  begins("a.exr", {}, "\x76\x2f\x31\x01");
  begins("b.ppm", {"--format", "p3"}, "P3\n");
  begins("b.dat", {"--format", "pfm"}, "PF\n");
  begins("none", {}, k_png);
  run_program({scene, "--quiet", "--format", "exr"});
  CHECK(f.has("a.exr"));
}

TEST_CASE("render: sizes, samples, threads and regions", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const auto picture = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {scene, "--quiet", "--format", "p3", "-o", "-"});
    const Result r = run_program(more);
    CHECK(r.exit_code == 0);
    return r.out;
  };
  CHECK(picture({}).find("P3\n12 8\n") == 0);
  CHECK(picture({"--size", "6,4"}).find("P3\n6 4\n") == 0);
  CHECK(picture({"--samples", "1"}) != picture({}));
  CHECK(picture({"--threads", "1"}) == picture({"--threads", "7"}));
  const std::string whole = picture({"--samples", "1"});
  const std::string part = picture({"--samples", "1", "--region", "0,3,12,5"});
  CHECK(part.find("P3\n12 2\n255\n") == 0);
  CHECK_THAT(whole, ContainsSubstring(part.substr(std::string("P3\n12 2\n255\n").size())));
  const Result outside = run_program({scene, "--region", "0,0,13,8"});
  CHECK(outside.exit_code == 2);
  CHECK(outside.err == "lancer: the region 0,0,13,8 reaches out of the picture, which has 12 x 8 pixels\n");
}

TEST_CASE("render: one view by its name, several and all", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write(
      "a.scn", k_scene + "view { eye x look -x size 2, 2 }\nview \"top\" { eye y look -y size 2, 2 }\n");
  CHECK(run_program({scene, "--view", "top", "--quiet", "-o", f.path("t.png")}).exit_code == 0);
  CHECK(run_program({scene, "--view", "view 1", "--quiet", "-o", f.path("u.png")}).exit_code == 0);
  CHECK(f.names() == Names{"a.scn", "t.png", "u.png"});
  CHECK(run_program({scene, "--view", "top", "--view", "front", "--view", "top", "--quiet"}).exit_code == 0);
  CHECK(f.names() == Names{"a-front.png", "a-top.png", "a.scn", "t.png", "u.png"});
  CHECK(f.read("a-top.png") == f.read("t.png"));
  const Result all = run_program({scene, "--all-views", "-o", f.path("x.ppm")});
  CHECK(all.exit_code == 0);
  CHECK(all.err.find("note:") == std::string::npos);
  for (const char* name : {"x-front.ppm", "x-top.ppm", "x-view-1.ppm", "x-top-2.ppm"}) CHECK(f.has(name));
}

TEST_CASE("render: all views of a scene with one still has its name", "[app][render]") {
  test::Folder f;
  CHECK(run_program({f.write("a.scn", "sphere { x, 1 }"), "--all-views", "--size", "4,4", "--quiet"})
            .exit_code == 0);
  CHECK(f.names() == Names{"a-automatic.png", "a.scn"});
}

TEST_CASE("render: an unknown view is a wrong command line", "[app][render]") {
  test::Folder f;
  const Result r = run_program({f.write("a.scn", k_scene), "--view", "fornt"});
  CHECK(r.exit_code == 2);
  CHECK(r.err == "lancer: there is no view `fornt` (did you mean `front`?); the views are `front`, `top`\n");
  CHECK_FALSE(f.has("a.png"));
}

TEST_CASE("render: a script from standard input becomes a picture on standard output", "[app][render]") {
  test::Folder f;
  const Result r =
      run_program({"-", "--samples", "1"}, {k_scene + "print(\"hello\")\n", f.root().string(), false, {}});
  CHECK(r.exit_code == 0);
  CHECK(r.out.find(k_png) == 0);
  CHECK(r.out.find("hello") == std::string::npos);
  CHECK_THAT(r.err, ContainsSubstring("hello\n"));
  CHECK_THAT(r.err, ContainsSubstring("wrote the picture to standard output, 12 x 8, in "));
  CHECK(f.names().empty());
  const Result file =
      run_program({"render", "-", "-o", "b.png", "--quiet"}, {k_scene, f.root().string(), false, {}});
  CHECK(file.exit_code == 0);
  CHECK(f.names() == Names{"b.png"});
  const Result two = run_program({"-", "--all-views"}, {k_scene, f.root().string(), false, {}});
  CHECK(two.exit_code == 2);
  CHECK(two.err.find("lancer: standard output takes one picture") == 0);
}

TEST_CASE("render: includes of a script from standard input are beside the working folder", "[app][render]") {
  test::Folder f;
  f.write("m.scn", "let r = 2\n");
  const Result r =
      run_program({"check", "--run", "-"}, {"include \"m.scn\"\nprint(r)\n", f.root().string(), false, {}});
  CHECK(r.exit_code == 0);
  CHECK(r.out == "2\n");
}

TEST_CASE("render: what a script prints is on standard output", "[app][render]") {
  test::Folder f;
  const Result r = run_program({f.write("a.scn", k_scene + "print(1, 2)\n")});
  CHECK(r.out == "1 2\n");
}

TEST_CASE("render: variables from outside", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "let n = 1\nprint(n)\n" + k_scene);
  CHECK(run_program({scene, "--quiet", "-D", "n=2 ^ 5"}).out == "32\n");
  CHECK(run_program({scene, "--quiet", "-Dn=\"a=b\""}).out == "a=b\n");
}

TEST_CASE("render: limits", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "for i in 0..100 { sphere { x, 1 } }\n");
  const Result steps = run_program({scene, "--max-steps", "50"});
  CHECK(steps.exit_code == 1);
  CHECK_THAT(steps.err, ContainsSubstring("error[E043]"));
  const Result objects = run_program({scene, "--max-objects", "50"});
  CHECK(objects.exit_code == 1);
  CHECK_THAT(objects.err, ContainsSubstring("error[E044]"));
  CHECK(run_program({scene, "--max-objects", "0", "--max-steps", "0", "--size", "2,2"}).exit_code == 0);
}

TEST_CASE("render: a wrong script is 1, with the place", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", "sphere { x, -1 }\n");
  const Result r = run_program({scene});
  CHECK(r.exit_code == 1);
  CHECK(r.err.find(scene + ":1:13: error[E013]: a sphere's radius is positive; this one is -1\n") == 0);
  CHECK(f.names() == Names{"a.scn"});
  const Result missing = run_program({f.write("b.scn", "include \"no.scn\"\n")});
  CHECK(missing.exit_code == 1);
  CHECK_THAT(missing.err, ContainsSubstring("b.scn:1:9: error[E040]"));
}

TEST_CASE("render: warnings are told, but not that a name is unused", "[app][render]") {
  test::Folder f;
  const Result r =
      run_program({f.write("a.scn", k_scene + "let unused = 1\nsettings { depth 1 }\nsettings { depth 2 }\n"),
                   "--quiet"});
  CHECK(r.exit_code == 0);
  CHECK_THAT(r.err, ContainsSubstring("warning[W103]"));
  CHECK(r.err.find("W101") == std::string::npos);
}

TEST_CASE("render: files that cannot be read or written are 3, in one line", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const auto trouble = [&](std::vector<std::string> arguments) {
    const Result r = run_program(arguments);
    CAPTURE(arguments, r.err);
    CHECK(r.exit_code == 3);
    CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
    CHECK(f.names() == Names{"a.scn"});
    return r.err;
  };
  CHECK(trouble({f.path("no.scn")}) == "lancer: cannot read " + f.path("no.scn") + ": no such file\n");
  CHECK(trouble({f.root().string()}) == "lancer: cannot read " + f.root().string() + ": it is a folder\n");
  CHECK(trouble({scene, "-o", f.path("no/a.png")}).find("lancer: cannot write ") == 0);
  CHECK(trouble({scene, "-o", f.root().string(), "--format", "png"}).find("lancer: cannot write ") == 0);
  CHECK(trouble({scene, "-o", "/dev/full"}).find("lancer: cannot write /dev/full") == 0);
}

TEST_CASE("render: a folder that may not be written is 3, before the work", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  std::filesystem::permissions(f.root(), std::filesystem::perms::owner_write,
                               std::filesystem::perm_options::remove);
  const Result r = run_program({scene, "--size", "20000,20000"}, {{}, {}, true, {}});
  std::filesystem::permissions(f.root(), std::filesystem::perms::owner_write,
                               std::filesystem::perm_options::add);
  CAPTURE(r.err);
  CHECK(r.exit_code == 3);
  CHECK(r.err.find("lancer: cannot write ") == 0);
  CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
}

TEST_CASE("render: a script that may not be read is 3", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  std::filesystem::permissions(scene, std::filesystem::perms::none);
  const Result r = run_program({scene}, {{}, {}, true, {}});
  CHECK(r.exit_code == 3);
  CHECK(r.err.find("lancer: cannot read " + scene + ": ") == 0);
}

TEST_CASE("render: a full standard output is 3", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene + "print(\"x\")\n");
  const Result picture = run_program({scene, "-o", "-", "--quiet"}, {{}, {}, false, "/dev/full"});
  CHECK(picture.exit_code == 3);
  CHECK(picture.err == "x\nlancer: cannot write to standard output: No space left on device\n");
  const Result print = run_program({scene}, {{}, {}, false, "/dev/full"});
  CHECK(print.exit_code == 3);
  CHECK(f.names() == Names{"a.scn"});
  CHECK(run_program({"--version"}, {{}, {}, false, "/dev/full"}).exit_code == 3);
}

TEST_CASE("render: a file that may not grow so large is 3", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  test::Setting setting;
  setting.largest_file = 512;
  const Result r =
      run_program({scene, "--size", "100,100", "--format", "pfm", "-o", f.path("a.pfm")}, setting);
  CHECK(r.exit_code == 3);
  CHECK(r.err == "lancer: cannot write " + f.path("a.pfm") + ": file too large\n");
  CHECK(f.names() == Names{"a.scn"});
}

TEST_CASE("render: more threads than the machine has are no cause for words", "[app][render]") {
  test::Folder f;
  const Result r = run_program({f.write("a.scn", k_scene), "--quiet", "--threads", "300"});
  CHECK(r.exit_code == 0);
  CHECK(r.err == "");
}

TEST_CASE("render: the script itself is not written over", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const Result r = run_program({scene, "-o", scene, "--format", "png"});
  CHECK(r.exit_code == 2);
  CHECK(f.read("a.scn") == k_scene);
  const std::string picture = f.write("b.png", k_scene);
  CHECK(run_program({picture}).exit_code == 2);
  CHECK(f.read("b.png") == k_scene);
}

TEST_CASE("render: stats as text and as JSON", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const Result text = run_program({scene, "--stats", "--quiet", "--samples", "16"});
  CHECK(text.out.empty());
  CHECK_THAT(text.err, ContainsSubstring("view `front`: 12 x 8 pixels, 16 samples each"));
  const Result json = run_program({scene, "--stats=json", "--quiet", "--samples", "4", "--threads", "1"});
  CHECK(json.err.empty());
  const auto stats = nlohmann::json::parse(json.out);
  CHECK(stats["view"] == "front");
  CHECK(stats["width"] == 12);
  CHECK(stats["height"] == 8);
  CHECK(stats["threads"] == 1);
  CHECK(stats["primary_rays"] == 12 * 8 * 4);
  CHECK(stats["shapes"] == 1);
  CHECK(stats["not_shot"]["lights_behind"] > 0);
  CHECK(stats["not_shot"]["rays_faint"] == 0);
  const Result refined = run_program({scene, "--stats", "--quiet", "--error", "0.05"});
  CHECK_THAT(refined.err, ContainsSubstring(" samples each for an error of 0.05; "));
  CHECK_THAT(refined.err, ContainsSubstring("% refined, "));
  const Result counted = run_program({scene, "--stats=json", "--quiet", "--error", "0.05"});
  const auto counts = nlohmann::json::parse(counted.out);
  CHECK(counts["samples"] == 0);
  CHECK(counts["error"] == 0.05);
  CHECK(counts["pixels_refined"] > 0);
  CHECK(counts["pixels_refined"] <= 12 * 8);
  const Result both = run_program({scene, "--stats=json", "--quiet", "-o", "-"});
  CHECK(both.out.find(k_png) == 0);
  CHECK(nlohmann::json::parse(both.err)["file"] == "-");
}

TEST_CASE("render: without skips the picture is the same, and costs more", "[app][render]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  const auto stats = [&](const std::string& out, const std::string& option) {
    const Result r =
        run_program({scene, "--stats=json", "--quiet", "--samples", "16", "-o", f.path(out), option});
    REQUIRE(r.exit_code == 0);
    return nlohmann::json::parse(r.out);
  };
  const auto with = stats("a.pfm", "--threads=1"), without = stats("b.pfm", "--no-skip"),
             lights = stats("c.pfm", "--no-skip=dark-lights,zero-terms");
  CHECK(f.read("a.pfm") == f.read("b.pfm"));
  CHECK(f.read("a.pfm") == f.read("c.pfm"));
  CHECK(with["node_visits"] == 0);
  CHECK(without["node_visits"] > 0);
  CHECK(lights["node_visits"] == 0);
  CHECK(lights["shadow_rays"] > with["shadow_rays"]);
  CHECK(lights["not_shot"]["lights_behind"] == 0);
}

TEST_CASE("render: a skip of no known name is refused with the one that was meant", "[app][render]") {
  test::Folder f;
  const Result r = run_program({f.write("a.scn", k_scene), "--no-skip=tree,mdia"});
  CHECK(r.exit_code == 2);
  CHECK(
      r.err.find("lancer: --no-skip: there is no skip `mdia` (did you mean `media`?); the skips are any-hit, "
                 "dark-lights, ") == 0);
}
