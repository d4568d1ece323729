#include "app/output_path.hpp"
#include "app/progress.hpp"
#include "catch.hpp"

using namespace lancer::app;
using Names = std::vector<std::string>;
using lancer::image::Format;

TEST_CASE("paths: a picture lies beside its script", "[app]") {
  CHECK(beside_script("lamp.scn", Format::png8) == "lamp.png");
  CHECK(beside_script("some/where.d/lamp", Format::exr) == "some/where.d/lamp.exr");
  CHECK(beside_script("../a.b.scn", Format::ppm_ascii) == "../a.b.ppm");
}

TEST_CASE("paths: each view has a file of its own", "[app]") {
  CHECK(paths_of_views("out/lamp.png", {"front", "top"}) == Names{"out/lamp-front.png", "out/lamp-top.png"});
  CHECK(paths_of_views("lamp", {"front"}) == Names{"lamp-front"});
}

TEST_CASE("paths: what does not belong in the name of a file is replaced, and clashes are counted", "[app]") {
  CHECK(paths_of_views("a.png", {"../x y", "a/b", "a:b", "a-b", "view 1", ""}) ==
        Names{"a-..-x-y.png", "a-a-b.png", "a-a-b-2.png", "a-a-b-3.png", "a-view-1.png", "a-.png"});
  CHECK(paths_of_views("a.png", {"v", "v-2", "v"}) == Names{"a-v.png", "a-v-2.png", "a-v-3.png"});
  const std::string umlaut = "\xC3\xA4";
  CHECK(paths_of_views("a.png", {umlaut}) == Names{"a-" + umlaut + ".png"});
  // A long name is cut between characters: 99 letters, then one of two bytes.
  const std::string letters(99, 'x');
  CHECK(paths_of_views("a.png", {letters + umlaut + umlaut}) == Names{"a-" + letters + ".png"});
}

TEST_CASE("progress: a line that fits", "[app]") {
  CHECK(progress_line("front", 0, 10, 78) == "front [..............................]   0 %");
  CHECK(progress_line("front", 5, 10, 78) == "front [###############...............]  50 %");
  CHECK(progress_line("front", 10, 10, 78) == "front [##############################] 100 %");
  CHECK(progress_line("front", 5, 10, 20) == "[#####......]  50 %");
  for (int columns = 0; columns < 60; ++columns)
    CHECK(progress_line("front", 5, 10, columns).size() <= static_cast<std::size_t>(columns));
}
