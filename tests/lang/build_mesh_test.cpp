#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "catch.hpp"
#include "lang/build.hpp"

using namespace lancer;
using namespace lancer::lang;

namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

// A tetrahedron, counter-clockwise from outside.
const std::string k_points = "points [<0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <0, 0, 1>] ";
const std::string k_faces = "faces [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] ";

std::string mesh(const std::string& content) { return "mesh { " + content + " }"; }

/// The corners of a cube of side 2 * `half` around the origin, numbered by bits (x lowest), and its six faces
/// from outside; `first` is the index of the first corner.
std::string cube_points(double half) {
  std::string out;
  for (int i = 0; i < 8; ++i) {
    const auto at = [&](int bit) { return (i >> bit & 1) != 0 ? half : -half; };
    out += fmt::format("<{}, {}, {}>, ", at(0), at(1), at(2));
  }
  return out;
}
std::string cube_faces(int first, bool inward) {
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::string out;
  for (const auto& f : faces) {
    const auto at = [&](int i) { return first + f[inward ? 3 - i : i]; };
    out += fmt::format("[{}, {}, {}, {}], ", at(0), at(1), at(2), at(3));
  }
  return out;
}

double volume(const scene::Mesh& m) {
  double out = 0;
  for (const auto& f : m.faces) out += dot(m.points[f[0]], cross(m.points[f[1]], m.points[f[2]])) / 6;
  return out;
}

}  // namespace

TEST_CASE("mesh: points and faces become facets, polygons fans", "[build][mesh]") {
  const scene::Scene s = scene_of(
      "mesh { points [<0,0,0>, <1,0,0>, <1,1,0>, <0,1,0>, <0,0,5>] faces [[0, 1, 2, 3], [0, 1, 4]] }");
  REQUIRE(s.meshes.size() == 1);
  CHECK(s.shapes[0].kind == scene::ShapeKind::mesh);
  CHECK(s.meshes[0].points.size() == 5);
  CHECK(s.meshes[0].faces == Faces{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}});
  CHECK(s.meshes[0].normals.empty());
  CHECK_FALSE(s.meshes[0].solid);
}

TEST_CASE("mesh: ranges and variables serve as lists", "[build][mesh]") {
  CHECK(scene_of("let p = [x, y, z]\nmesh { points p faces [0..3] }").meshes[0].faces == Faces{{0, 1, 2}});
}

TEST_CASE("mesh: smooth normals are area-weighted means", "[build][mesh]") {
  // Two triangles share the edge from 0 to 1. Twice their area times their normal: (1,0,0) x (0,1,0) = (0, 0,
  // 1) and (1,0,0) x (0,0,2) = (0, -2, 0); the shared points have the direction of the sum, (0, -2, 1).
  const scene::Mesh m =
      scene_of(
          "mesh { points [<0,0,0>, <1,0,0>, <0,1,0>, <0,0,2>] faces [[0, 1, 2], [0, 1, 3]] smooth true }")
          .meshes[0];
  const double r = std::sqrt(5.0);
  REQUIRE(m.normals.size() == 4);
  CHECK(is_near(m.normals[0], {0, -2 / r, 1 / r}));
  CHECK(is_near(m.normals[1], {0, -2 / r, 1 / r}));
  CHECK(m.normals[2] == Vec3{0, 0, 1});
  CHECK(m.normals[3] == Vec3{0, -1, 0});
}

TEST_CASE("mesh: smooth normals do not depend on how large the mesh is", "[build][mesh]") {
  for (const char* unit : {"1e-150", "1", "1e150"}) {
    const std::string u = unit;
    const scene::Mesh m =
        scene_of(
            "let u = " + u +
            "\nmesh { points [<0,0,0>, <u,0,0>, <0,u,0>, <0,0,u>] faces [[0, 1, 2], [0, 1, 3]] smooth true }")
            .meshes[0];
    CHECK(is_near(m.normals[0], {0, -std::sqrt(0.5), std::sqrt(0.5)}));
  }
}

TEST_CASE("mesh: a solid one wound outwards stays, one wound inwards is turned", "[build][mesh]") {
  const scene::Mesh out = scene_of(mesh(k_points + k_faces + "solid true smooth true")).meshes[0];
  CHECK(out.solid);
  CHECK(out.faces == Faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  const scene::Mesh in =
      scene_of(mesh(k_points + "faces [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]] solid true smooth true"))
          .meshes[0];
  CHECK(volume(in) == Approx(1.0 / 6));
  for (std::size_t i = 0; i < 4; ++i) CHECK(is_near(in.normals[i], out.normals[i]));
}

TEST_CASE("mesh: a solid one is closed and winds one way", "[build][mesh][refusals]") {
  CHECK(refusal(mesh(k_points + "faces [[0, 2, 1], [0, 1, 3], [0, 3, 2]] solid true")) ==
        "E046 [mesh] a solid mesh is closed; this one has a hole");
  CHECK(refusal(mesh(k_points + "faces [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 3, 2]] solid true")) ==
        "E046 [mesh] a solid mesh winds the same way throughout");
  CHECK(refusal("mesh { points [x, y, z] faces [[0, 1, 2], [0, 2, 1]] solid true }")
            .find("E046 [mesh] a solid mesh encloses a volume") == 0);
}

TEST_CASE("mesh: faces with points of their own are closed where these lie at the same places",
          "[build][mesh]") {
  std::string points, faces;
  const char* corners[4] = {"<0,0,0>", "<1,0,0>", "<0,1,0>", "<-0.0,0,1>"};
  const int f[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (int i = 0; i < 4; ++i) {
    points += fmt::format("{}, {}, {}, ", corners[f[i][0]], corners[f[i][1]], corners[f[i][2]]);
    faces += fmt::format("[{}, {}, {}], ", 3 * i, 3 * i + 1, 3 * i + 2);
  }
  CHECK(scene_of(mesh("points [" + points + "] faces [" + faces + "] solid true")).meshes[0].solid);
}

TEST_CASE("mesh: a hollow within a solid winds the other way", "[build][mesh]") {
  const std::string points = "points [" + cube_points(2) + cube_points(1) + "] ";
  const auto with = [&](bool outer, bool inner) {
    return mesh(points + "faces [" + cube_faces(0, outer) + cube_faces(8, inner) + "] solid true");
  };
  // 4^3 - 2^3 = 56.
  CHECK(volume(scene_of(with(false, true)).meshes[0]) == Approx(56));
  CHECK(volume(scene_of(with(true, false)).meshes[0]) == Approx(56));
}

TEST_CASE("mesh: separate parts of a solid wind the same way", "[build][mesh][refusals]") {
  const std::string first = "<0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <0, 0, 1>, ";
  const std::string second = "<5, 0, 0>, <6, 0, 0>, <5, 1, 0>, <5, 0, 1>";
  const std::string faces = "faces [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], ";
  CHECK(volume(scene_of(mesh("points [" + first + second + "] " + faces +
                             "[4, 6, 5], [4, 5, 7], [4, 7, 6], [5, 6, 7]] solid true"))
                   .meshes[0]) == Approx(2.0 / 6));
  CHECK(refusal(mesh("points [" + first + second + "] " + faces +
                     "[4, 5, 6], [4, 7, 5], [4, 6, 7], [5, 7, 6]] solid true")) ==
        "E046 [mesh] a solid mesh winds the same way throughout");
}

TEST_CASE("mesh: wrong indices are refused at the index", "[build][mesh][refusals]") {
  CHECK(refusal("mesh { points [x, y, z] faces [[0, 1, 2], [0, 1, 3]] }") ==
        "E046 [3] the index 3 is out of range: there are 3 points");
  CHECK(refusal("mesh { points [x, y, z] faces [[0, 1, -1]] }") ==
        "E046 [-1] the index -1 is out of range: there are 3 points");
  CHECK(refusal("mesh { points [x, y, z] faces [[0, 1, 0.5]] }") ==
        "E046 [0.5] an index is whole; this one is 0.5");
  // Where the list was not written out, at what stands for it.
  CHECK(refusal("let f = [0, 1, 7]\nmesh { points [x, y, z] faces [f] }") ==
        "E046 [f] the index 7 is out of range: there are 3 points");
}

TEST_CASE("mesh: what is no mesh is refused", "[build][mesh][refusals]") {
  CHECK(refusal("mesh { points x faces [[0, 1, 2]] }") ==
        "E030 [x] `points` takes a list of points; this is a vector");
  CHECK(refusal("mesh { points [x, 2] faces [[0, 1, 2]] }") ==
        "E030 [2] a mesh's points are vectors of 3; number 1 is a number");
  CHECK(refusal("mesh { points [x, y, z] faces [] }") ==
        "E046 [[]] a mesh has at least one face; this one has none");
  CHECK(refusal("mesh { points [x, y, z] faces [[0, 1]] }") ==
        "E046 [[0, 1]] a mesh's face has three or more indices; this one has 2");
  CHECK(refusal("mesh { points [x, y, z] faces [2] }") ==
        "E030 [2] a mesh's face is a list of indices; this is a number");
  CHECK(refusal("mesh { points [x, 2 * x, 3 * x] faces [[0, 1, 2]] }") ==
        "E046 [[[0, 1, 2]]] a mesh has faces with an area; all of these are flat");
  CHECK(refusal("mesh { file \"bunny.obj\" }") ==
        "E047 [\"bunny.obj\"] meshes from files come with a later version");
}

TEST_CASE("mesh: flat faces among others are left out", "[build][mesh]") {
  CHECK(scene_of("mesh { points [<0,0,0>, x, 2 * x, y] faces [[0, 1, 2], [0, 1, 3], [0, 0, 3, 1]] }")
            .meshes[0]
            .faces == Faces{{0, 1, 3}, {0, 3, 1}});
}

TEST_CASE("mesh: one that is placed twice is stored once", "[build][mesh]") {
  const scene::Scene s =
      scene_of("let m = mesh { points [x, y, z] faces [[0, 1, 2]] }\nm\ngroup { m translate y }");
  CHECK(s.shapes.size() == 2);
  CHECK(s.meshes.size() == 1);
  CHECK(s.shapes[1].record == 0);
}
