#pragma once
// What is to be seen: plain data with indices, not pointers; const once evaluated. Everything in it was
// checked when it was made, so that the tracer never has to.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/color.hpp"
#include "base/source.hpp"
#include "base/transform.hpp"
#include "base/vec.hpp"

namespace lancer::scene {

using Index = std::uint32_t;
inline constexpr Index k_none = 0xFFFFFFFF;

// --- Looks
// ---------------------------------------------------------------------------------------------------

/// A colour that depends on the point, in the space of the shape that wears it.
struct Pattern {
  enum class Kind : std::uint8_t { checker, stripes, gradient };
  Kind kind = Kind::checker;
  Color a, b;
  double size = 1;  // checker: the edge of a cell; stripes: the width of one; > 0
  Vec3 axis;        // stripes: any length but zero
  Vec3 from, to;    // gradient; not the same point
  friend bool operator==(const Pattern&, const Pattern&) = default;
};

/// One colour, or a pattern of the scene's list.
struct Texture {
  Color color;
  Index pattern = k_none;
  friend bool operator==(const Texture&, const Texture&) = default;
};

/// Coefficients >= 0; ior > 0.
struct Material {
  Texture ambient{{0.8, 0.8, 0.8}};
  Texture diffuse{{0.8, 0.8, 0.8}};
  Texture specular;
  Texture reflection;
  Texture transmission;
  double shininess = 32;
  double ior = 1;
  bool fresnel = false;
  friend bool operator==(const Material&, const Material&) = default;
};

// --- Shapes, each in its own space
// ---------------------------------------------------------------------------

struct Sphere {
  Vec3 center;
  double radius = 1;
};

/// The points p with (p - point) . normal / |normal| = offset; inside is the side the normal points away
/// from.
struct Plane {
  Vec3 point;
  Vec3 normal;
  double offset = 0;
};

/// [lo, hi] in its own frame; `frame` is the place in Scene::transforms of the map from that frame to the
/// shape's space (three-point cubes), 0 for the identity.
struct Box {
  Vec3 lo, hi;
  Index frame = 0;
};

/// A triangle, normal (b-a) x (c-a). `normals` is the place in Scene::facet_normals, or k_none for a flat
/// one.
struct Facet {
  Vec3 a, b, c;
  Index normals = k_none;
};

/// Triangles that share points. `normals` has one unit vector a point, or none where the mesh is flat. A
/// solid one is closed and winds counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<Vec3> normals;
  bool solid = false;
};

enum class ShapeKind : std::uint8_t { sphere, plane, box, facet, mesh };

/// A shape as placed in the scene. Shapes stand in the order in which they were added, which decides between
/// coincident surfaces.
struct Shape {
  ShapeKind kind = ShapeKind::sphere;
  bool shadow = true;
  Index record = 0;  // in the list of its kind
  Index material = 0;
  Index transform = 0;  // own space to world; Scene::transforms[0] is the identity
  Index name = 0;       // Scene::names[0] is the empty name
  Span source;
};

// --- Lights and views, in world space
// ------------------------------------------------------------------------

enum class LightKind : std::uint8_t { point, sun, spot };

struct Light {
  LightKind kind = LightKind::point;
  Vec3 at;         // point, spot
  Vec3 at_rest;    // what is below its last bits (see Place)
  Vec3 direction;  // sun: the way its light travels; spot: where it points; any length but zero
  Color color{1, 1, 1};
  double falloff = 0;     // inverse square, 1 at this distance; 0: none
  double angle = 30;      // spot: full opening, degrees, in (0, 180)
  double softness = 0.1;  // spot: 0..1
  Index name = 0;
  Span source;
};

enum class Projection : std::uint8_t { perspective, orthographic, corners };

struct View {
  Projection projection = Projection::perspective;
  Vec3 eye;
  Vec3 eye_rest;                // what is below its last bits (see Place)
  Vec3 look{0, 0, -1};          // any length but zero
  Vec3 up{0, 1, 0};             // not along look
  double fov = 50;              // perspective: horizontal, degrees, in (0, 180)
  double width = 1;             // orthographic: of the screen, > 0
  std::array<Vec3, 3> corners;  // corners: top-left, top-right, bottom-left
  std::array<Vec3, 3> corner_rests;
  int columns = 640, rows = 480;
  Index name = 0;
  Span source;
};

enum class Shadows : std::uint8_t { filtered, opaque, off };
enum class Sum : std::uint8_t { linear, log };

struct Settings {
  Color background;
  Color ambient{0.1, 0.1, 0.1};
  int depth = 8;
  double ior = 1;
  Shadows shadows = Shadows::filtered;
  Sum sum = Sum::linear;
  double exposure = 1;
};

struct Scene {
  Settings settings;
  std::vector<Transform> transforms{Transform{}};
  std::vector<Material> materials;
  std::vector<Pattern> patterns;
  std::vector<Shape> shapes;
  std::vector<Sphere> spheres;
  std::vector<Plane> planes;
  std::vector<Box> boxes;
  std::vector<Facet> facets;
  std::vector<std::array<Vec3, 3>> facet_normals;  // unit length
  std::vector<Mesh> meshes;
  std::vector<Light> lights;
  std::vector<View> views;
  std::vector<std::string> names{""};
};

/// The view that frames everything in the scene, for a script without one: 640 x 480, seen from a little
/// above and to the right of the front.
View automatic_view(const Scene& scene);

/// A readable, deterministic listing of everything in the scene, for `dump --scene` and for tests. Numbers
/// are printed with the fewest digits that read back the same.
std::string dump(const Scene& scene);

}  // namespace lancer::scene
