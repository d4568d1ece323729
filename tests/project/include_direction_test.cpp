#include "project/include_direction.hpp"

#include "catch.hpp"
#include "project/source_tree.hpp"

using Found = std::vector<std::string>;

TEST_CASE("includes: no room looks where it must not", "[project]") {
  int files = 0;
  for (const TreeFile& file : source_tree()) {
    if (!file.path.ends_with(".hpp") && !file.path.ends_with(".cpp")) continue;
    const std::string room = room_of(file.path);
    if (room.empty()) continue;
    ++files;
    CAPTURE(file.path);
    CHECK(forbidden_includes(room, file.text) == Found{});
  }
  CHECK(files > 50);
}

TEST_CASE("includes: the room of a file", "[project]") {
  CHECK(room_of("src/base/vec.hpp") == "base");
  CHECK(room_of("src/tracer/shapes/box.cpp") == "tracer");
  CHECK(room_of("grammar/parse.cpp") == "grammar");
  CHECK(room_of("tests/base/vec_test.cpp").empty());
  CHECK(room_of("CMakeLists.txt").empty());
}

TEST_CASE("includes: what is forbidden is found, with its line", "[project]") {
  const std::string text =
      "#pragma once\n"
      "#include <vector>\n"
      "\n"
      "#include \"base/vec.hpp\"\n"
      "#include \"lang/value.hpp\"\n"
      "  #  include <tracer/render.hpp>\n"
      "#include \"../scene/scene.hpp\"";
  CHECK(forbidden_includes("base", text) ==
        Found{"line 5: lang/value.hpp", "line 6: tracer/render.hpp", "line 7: ../scene/scene.hpp"});
  CHECK(forbidden_includes("tracer", text) == Found{"line 5: lang/value.hpp", "line 7: ../scene/scene.hpp"});
}

TEST_CASE("includes: a room may see some headers of another and not the rest", "[project]") {
  CHECK(forbidden_includes("grammar", "#include \"lang/ast.hpp\"\n#include \"lang/value.hpp\"\n") ==
        Found{"line 2: lang/value.hpp"});
  CHECK(forbidden_includes("app", "#include \"tracer/options.hpp\"\n#include \"tracer/bvh.hpp\"\n") ==
        Found{"line 2: tracer/bvh.hpp"});
  CHECK(forbidden_includes("lang", "#include \"grammar/parse.hpp\"\n") == Found{"line 1: grammar/parse.hpp"});
}

TEST_CASE("includes: a library that is one room's business is found in another", "[project]") {
  const std::string text = "#include <tao/pegtl.hpp>\n#include <iostream>\n#include <nlohmann/json.hpp>\n";
  CHECK(forbidden_includes("lang", text) ==
        Found{"line 1: tao/pegtl.hpp", "line 2: iostream", "line 3: nlohmann/json.hpp"});
  CHECK(forbidden_includes("grammar", text) == Found{"line 2: iostream", "line 3: nlohmann/json.hpp"});
  CHECK(forbidden_includes("app", text) == Found{"line 1: tao/pegtl.hpp"});
}
