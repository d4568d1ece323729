#include "random_scene.hpp"

namespace lancer::tracer::test {
namespace {

class SceneByLot {
 public:
  explicit SceneByLot(std::uint64_t seed) : random_(seed) {}

  Scene run() {
    traits();
    settings();
    const int shapes = chance(0.4) ? 1 + whole(6) : 10 + whole(25);
    for (int i = 0; i < shapes; ++i) shape();
    const int lights = chance(0.6) ? whole(5) : 5 + whole(10);
    for (int i = 0; i < lights; ++i) light();
    for (int i = 0; i < 3; ++i) s_.materials.push_back(material());  // that nothing wears
    return std::move(s_);
  }

 private:
  bool chance(double p) { return random_() < p; }
  int whole(int below) { return static_cast<int>(random_() * below); }
  Color color(double most) { return {random_() * most, random_() * most, random_() * most}; }

  void traits() {
    clear_ = chance(0.5);
    bends_ = chance(0.6);
    mirrors_ = chance(0.5);
    patterns_ = chance(0.5);
    all_cast_ = chance(0.7);
  }

  void settings() {
    s_.settings.background = chance(0.3) ? Color{} : color(1);
    s_.settings.ambient = chance(0.3) ? Color{} : color(0.4);
    s_.settings.depth = chance(0.1) ? 0 : 1 + whole(5);
    s_.settings.ior = bends_ && chance(0.3) ? 1.2 : 1;
    s_.settings.shadows = chance(0.6)   ? scene::Shadows::filtered
                          : chance(0.7) ? scene::Shadows::opaque
                                        : scene::Shadows::off;
    s_.settings.sum = chance(0.25) ? scene::Sum::log : scene::Sum::linear;
    s_.settings.exposure = chance(0.5) ? 1 : 0.5 + 2 * random_();
  }

  scene::Texture texture(double most) {
    scene::Texture out{chance(0.2) ? Color{} : color(most)};
    if (!patterns_ || !chance(0.4)) return out;
    scene::Pattern pattern;
    const double kind = random_();
    pattern.kind = kind < 0.4   ? scene::Pattern::Kind::checker
                   : kind < 0.7 ? scene::Pattern::Kind::stripes
                                : scene::Pattern::Kind::gradient;
    pattern.a = chance(0.3) ? Color{} : color(most);
    pattern.b = chance(0.3) ? Color{} : color(most);
    pattern.size = 0.3 + random_();
    pattern.axis = random_.direction();
    pattern.from = random_.in_cube(1);
    pattern.to = pattern.from + random_.direction();
    s_.patterns.push_back(pattern);
    return {{}, static_cast<Index>(s_.patterns.size() - 1)};
  }

  Material material() {
    Material m;
    m.ambient = m.diffuse = chance(0.8) ? texture(0.9) : scene::Texture{};
    if (chance(0.4)) m.specular = texture(0.6);
    m.shininess = 1 + 60 * random_();
    if (mirrors_ && chance(0.4)) m.reflection = texture(0.7);
    if (clear_ && chance(0.5)) m.transmission = texture(0.9);
    if (bends_ && chance(0.6)) m.ior = 1 + random_();
    m.fresnel = chance(0.5);
    return m;
  }

  Affine placed() {
    Affine map = rotation(random_.in_cube(180));
    if (chance(0.3)) map = then(scaling({0.5 + random_(), 0.5 + random_(), 0.5 + random_()}), map);
    return then(map, translation(random_.in_cube(3)));
  }

  void shape() {
    const Material m = material();
    const double kind = random_();
    const Affine map = chance(0.6) ? placed() : Affine{};
    if (kind < 0.35) {
      add_sphere(s_, random_.in_cube(2), 0.2 + random_(), m, map);
    } else if (kind < 0.5) {
      const Vec3 corner = random_.in_cube(2);
      add_box(s_, corner, corner + Vec3{0.3 + random_(), 0.3 + random_(), 0.3 + random_()}, m, map);
    } else if (kind < 0.6) {
      add_plane(s_, random_.in_cube(1) - Vec3{0, 3, 0}, {0.2 * random_(), 1, 0.1}, m);
    } else if (kind < 0.85) {
      add_facet(s_, random_.in_cube(3), random_.in_cube(3), random_.in_cube(3), m, map);
    } else {
      add_mesh(s_, cube_mesh(chance(0.7)), m, map);
    }
    s_.shapes.back().shadow = all_cast_ || chance(0.6);
  }

  void light() {
    scene::Light light;
    const double kind = random_();
    light.kind = kind < 0.4   ? scene::LightKind::point
                 : kind < 0.6 ? scene::LightKind::sun
                              : scene::LightKind::spot;
    light.at = random_.direction() * (3 + 5 * random_());
    light.direction = chance(0.7) ? -light.at : random_.direction();
    light.color = chance(0.2) ? Color{} : color(1);
    light.falloff = chance(0.4) ? 4 * random_() : 0;
    light.angle = 10 + 80 * random_();
    light.softness = random_();
    s_.lights.push_back(light);
  }

  Random random_;
  Scene s_;
  bool clear_ = false, bends_ = false, mirrors_ = false, patterns_ = false, all_cast_ = true;
};

}  // namespace

Scene random_scene(std::uint64_t seed) { return SceneByLot(seed).run(); }

scene::View random_view(std::uint64_t seed, int columns, int rows) {
  Random random(seed + 1000);
  const bool outside = random() < 0.7;
  const Vec3 eye = outside ? random.direction() * 9 : random.in_cube(1.5);
  scene::View v = view(eye, outside ? random.in_cube(1) - eye : random.direction(), 1, 60);
  v.columns = columns;
  v.rows = rows;
  if (random() < 0.2) {
    v.projection = scene::Projection::orthographic;
    v.width = 8;
  }
  return v;
}

}  // namespace lancer::tracer::test
