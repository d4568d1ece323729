#include "image/format.hpp"

#include "catch.hpp"

using namespace lancer::image;

TEST_CASE("format: a path's ending names it, capitals or not", "[format]") {
  CHECK(format_from_path("a.png") == Format::png8);
  CHECK(format_from_path("folder.exr/a.PNG") == Format::png8);
  CHECK(format_from_path("/a/b.c.ppm") == Format::ppm);
  CHECK(format_from_path("x.Pfm") == Format::pfm);
  CHECK(format_from_path("x.EXR") == Format::exr);
}

TEST_CASE("format: a path with another ending or none names nothing", "[format]") {
  CHECK(format_from_path("") == std::nullopt);
  CHECK(format_from_path("png") == std::nullopt);
  CHECK(format_from_path("a.jpeg") == std::nullopt);
  CHECK(format_from_path("a.png.") == std::nullopt);
  CHECK(format_from_path("folder.png/a") == std::nullopt);
}

TEST_CASE("format: a name on the command line", "[format]") {
  CHECK(format_from_name("png") == Format::png8);
  CHECK(format_from_name("png16") == Format::png16);
  CHECK(format_from_name("ppm") == Format::ppm);
  CHECK(format_from_name("p6") == Format::ppm);
  CHECK(format_from_name("p3") == Format::ppm_ascii);
  CHECK(format_from_name("pfm") == Format::pfm);
  CHECK(format_from_name("exr") == Format::exr);
  CHECK(format_from_name("jpeg") == std::nullopt);
  CHECK(format_from_name("") == std::nullopt);
}
