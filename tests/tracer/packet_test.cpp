// Rays that are traced together see what each sees by itself, bit for bit.

#include "base/math.hpp"
#include "catch.hpp"
#include "random_scene.hpp"
#include "tracer/packet/kernels.hpp"
#include "tracer/packet/scenery.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Rendered with_skips(const Scene& s, const scene::View& v, int samples, Skips skips) {
  Options options;
  options.samples = samples;
  options.threads = 1;
  options.skips = skips;
  return render(s, v, options);
}

/// Draws it in both ways; the picture and what was shot must be the same.
Stats check_same(const Scene& s, const scene::View& v, int samples = 1) {
  REQUIRE(plan(s, v, {}).packets);
  const Rendered together = with_skips(s, v, samples, Skips::all());
  const Rendered alone = with_skips(s, v, samples, Skips::all().without(Skip::single_rays));
  std::size_t different = 0, first = 0;
  for (std::size_t i = together.image.data().size(); i-- > 0;) {
    if (together.image.data()[i] == alone.image.data()[i]) continue;
    first = i / 3;
    ++different;
  }
  INFO("the first other pixel: " << first);
  REQUIRE(different == 0);
  CHECK(together.stats.primary_rays == alone.stats.primary_rays);
  CHECK(together.stats.reflected_rays == alone.stats.reflected_rays);
  CHECK(together.stats.shadow_rays == alone.stats.shadow_rays);
  CHECK(together.stats.refracted_rays == alone.stats.refracted_rays);
  CHECK(together.stats.medium_changes == alone.stats.medium_changes);
  CHECK(together.stats.branchings == alone.stats.branchings);
  CHECK(together.stats.pattern_lookups == alone.stats.pattern_lookups);
  CHECK(together.stats.lights_behind == alone.stats.lights_behind);
  CHECK(together.stats.lights_outside_cone == alone.stats.lights_outside_cone);
  CHECK(together.stats.lights_unanswered == alone.stats.lights_unanswered);
  return together.stats;
}

/// A scene by lot in which rays can go together; half of them lets no light through.
Scene some_scene(std::uint64_t seed) {
  Scene s = random_scene(seed);
  s.settings.sum = scene::Sum::linear;
  if (seed % 2 == 0) {
    for (scene::Material& m : s.materials) m.transmission = {};
  }
  std::erase_if(s.lights, [](const scene::Light& l) { return l.kind == scene::LightKind::spot; });
  return s;
}

bool goes_together(const Scene& s, const scene::View& v) { return plan(s, v, {}).packets; }

Material shiny(Color color) {
  Material m;
  m.ambient.color = color * 0.2;
  m.diffuse.color = color * 0.6;
  m.specular.color = grey(0.4);
  m.shininess = 37.3;
  m.reflection.color = grey(0.4);
  return m;
}

/// Many balls, small and large, on a floor of two facets.
Scene balls_and_floor(int count, double size, Vec3 at = {}) {
  Scene s;
  Random random(7);
  s.settings.background = {0.1, 0.3, 0.7};
  const auto place = [&](double x, double y, double z) { return Vec3{x, y, z} * size + at; };
  add_facet(s, place(-9, -1, -9), place(9, -1, 9), place(9, -1, -9), matt(0.7));
  add_facet(s, place(-9, -1, -9), place(-9, -1, 9), place(9, -1, 9), matt(0.7));
  for (int i = 0; i < count; ++i) {
    const Vec3 c = random.in_cube(2);
    const double r = (0.02 + 0.5 * random() * random()) * size;
    add_sphere(s, place(c.x, c.y, c.z), r, shiny({random(), random(), random()}));
  }
  s.lights.push_back(point_light(place(5, 8, 6), 0.8));
  s.lights.push_back(point_light(place(-6, 5, 2), 0.5));
  return s;
}

scene::View towards(Vec3 eye, Vec3 middle, int n) { return view(eye, middle - eye, n); }

}  // namespace

TEST_CASE("packet: scenes by lot are the same, together or alone", "[packet]") {
  int drawn = 0;
  for (std::uint64_t seed = 1; seed <= 240; ++seed) {
    const Scene s = some_scene(seed);
    const scene::View v = random_view(seed, 37, 21);
    if (!goes_together(s, v)) continue;
    INFO("seed " << seed);
    check_same(s, v, 1 + static_cast<int>(seed % 3));
    ++drawn;
  }
  CHECK(drawn > 180);
}

TEST_CASE("packet: few and many things, near and far, small and large", "[packet]") {
  for (const int count : {1, 5, 40, 900}) {
    for (const double size : {1.0, 1e-140, 1e140}) {
      INFO(count << " balls of size " << size);
      const Scene s = balls_and_floor(count, size);
      check_same(s, towards(Vec3{0.5, 2, 6} * size, {}, 90));
    }
    const Vec3 far{3e6, -2e7, 1e6};
    check_same(balls_and_floor(count, 1, far), towards(far + Vec3{0.5, 2, 6}, far, 90));
    // From among the balls, in a cone that is wide.
    check_same(balls_and_floor(count, 1), view({0.1, 0.2, -0.3}, {0.3, -0.4, 1}, 90, 120));
    // From so far that boxes are approached first.
    check_same(balls_and_floor(count, 1), view({300, 700, 1000}, {-300, -700, -1000}, 90, 0.3));
  }
}

TEST_CASE("packet: what lies in one plane, touches and is cut off at edges", "[packet]") {
  Scene s;
  add_plane(s, {0, -1, 0}, {0, 1, 0}, shiny({1, 0.8, 0.6}));
  add_plane(s, {0, -1, 0}, {0, -1, 0}, shiny({0.2, 0.8, 0.6}));  // the same plane
  add_plane(s, {0, 0, -6}, {0.1, 0.2, 1}, shiny({0.5, 0.5, 0.6}));
  add_sphere(s, {0, 0, 0}, 1, shiny({0.9, 0.2, 0.2}));  // stands on it
  add_sphere(s, {2, 0, 0}, 1, shiny({0.2, 0.9, 0.2}));  // touches the other
  add_sphere(s, {2, 0, 0}, 1, shiny({0.2, 0.2, 0.9}));  // the same ball again
  add_mesh(s, cube_mesh(true), shiny({0.7, 0.7, 0.2}), translation({-3, 0, -1}));
  add_mesh(s, cube_mesh(false), shiny({0.2, 0.7, 0.7}),
           then(rotation({10, 30, 0}), translation({-1, 0, -4})));
  add_box(s, {1, -1, 1}, {1.5, -0.5, 1.5}, shiny({0.7, 0.2, 0.7}));
  s.lights.push_back(point_light({4, 5, 3}, 0.9));
  s.lights.push_back(sun({-1, -2, -1.5}, 0.4));
  const Stats stats = check_same(s, view({0, 0.5, 6}, {0, -0.1, -1}, 120, 60), 2);
  CHECK(stats.reflected_rays > 10000);
  check_same(s, view({0, 0, 6}, {0, 0, -1}, 64));  // rays that run along axes, and in planes
}

TEST_CASE("packet: lights that fade, shine in cones, stand at a surface, or let no shadow fall", "[packet]") {
  Scene s = balls_and_floor(30, 1);
  s.lights[0].falloff = 4;
  s.lights[1].kind = scene::LightKind::spot;
  s.lights[1].direction = {6, -5, -2};
  s.lights[1].angle = 30;
  s.lights[1].softness = 0.5;
  s.lights.push_back(point_light({0, -1, 2}, 0.3));  // in the floor
  const scene::View v = towards({0.5, 2, 6}, {}, 80);
  check_same(s, v);
  for (const scene::Shadows how : {scene::Shadows::off, scene::Shadows::opaque, scene::Shadows::filtered}) {
    s.settings.shadows = how;
    s.shapes[5].shadow = false;
    s.materials[4].shininess = 1;
    s.materials[6].specular.color = {};
    check_same(s, v);
  }
}

TEST_CASE("packet: parts of a picture are those of the whole, on any number of threads", "[packet]") {
  const Scene s = balls_and_floor(50, 1);
  const scene::View v = towards({0.5, 2, 6}, {}, 61);
  Options options;
  options.samples = 4;
  options.threads = 3;
  const std::vector<float> whole = render(s, v, options).image.data();
  options.threads = 1;
  CHECK(render(s, v, options).image.data() == whole);
  options.region = Region{7, 11, 40, 30};
  const image::Image part = render(s, v, options).image;
  bool same = true;
  for (int y = 11; y < 30; ++y) {
    for (int x = 7; x < 40; ++x) {
      for (int c = 0; c < 3; ++c)
        same = same && part.pixel(x - 7, y - 11)[static_cast<std::size_t>(c)] ==
                           whole[static_cast<std::size_t>((y * 61 + x) * 3 + c)];
    }
  }
  CHECK(same);
}

TEST_CASE("packet: rays go together through glass, and by filtered shadows", "[packet]") {
  check_same(still_life(), view({0, 0.5, 6}, {0, -0.1, -1}, 70), 2);
  check_same(still_life(), view({0, 0, 0.2}, {0, 0, 1}, 40));  // from within glass: one by one after all
  Scene s = balls_and_floor(40, 1);
  for (std::size_t i = 4; i < 30; i += 3) {
    s.materials[i].transmission.color = {0.3, 0.5, 0.2};
    s.materials[i].ior = 1.4;
  }
  const Stats stats = check_same(s, towards({0.5, 2, 6}, {}, 90));
  CHECK(stats.refracted_rays > 1000);
  s.settings.shadows = scene::Shadows::opaque;
  check_same(s, towards({0.5, 2, 6}, {}, 60));
  for (scene::Material& m : s.materials) m.ior = 1;
  check_same(s, towards({0.5, 2, 6}, {}, 60));
}

namespace {

Material glass(Random& random, bool fresnel) {
  Material m = shiny({random(), random(), random()});
  m.transmission.color = {0.3 + 0.6 * random(), 0.3 + 0.6 * random(), 0.3 + 0.6 * random()};
  m.reflection.color = grey(random() < 0.5 ? 0 : 0.2);
  m.ior = random() < 0.2 ? 1 : 1 + random();
  m.fresnel = fresnel;
  return m;
}

/// Balls, boxes and closed meshes of glass in, through and beside each other, some opaque things among them.
Scene glass_heap(std::uint64_t seed, bool fresnel) {
  Random random(seed);
  Scene s;
  s.settings.background = {0.1, 0.3, 0.7};
  s.settings.depth = 6;
  add_plane(s, {0, -1, 0}, {0, 1, 0}, shiny({1, 0.8, 0.6}));
  for (int i = 0; i < 14; ++i) {
    const Vec3 at = random.in_cube(1.5);
    const double r = 0.2 + 0.8 * random();
    const Material m = i % 5 == 4 ? shiny({0.9, 0.4, 0.3}) : glass(random, fresnel && random() < 0.7);
    switch (i % 7) {
      case 0:
      case 1:
      case 2: add_sphere(s, at, r, m); break;
      case 3:
      case 4: add_box(s, at, at + Vec3{r, 0.7 * r, 1.2 * r}, m); break;
      case 5:
        add_box(s, {-r, -r, -r}, {r, r, 0.5 * r}, m,
                then(rotation({50 * random(), 70 * random(), 20}), translation(at)));
        break;
      case 6: add_mesh(s, cube_mesh(true), m, then(rotation({10, 30, 0}), translation(at))); break;
    }
    s.shapes.back().shadow = random() < 0.9;
  }
  s.lights.push_back(point_light({5, 8, 6}, 0.8));
  s.lights.push_back(point_light(random.in_cube(1), 0.5));
  s.lights.push_back(sun({-1, -2, -1.5}, 0.4));
  return s;
}

}  // namespace

TEST_CASE("packet: heaps of glass are the same, together or alone", "[packet]") {
  std::uint64_t refracted = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    Scene s = glass_heap(seed, seed % 2 == 0);
    if (seed % 5 == 0) s.settings.shadows = scene::Shadows::opaque;
    if (seed % 7 == 0) s.settings.ior = 1.3;
    refracted += check_same(s, view({0.5, 1, 6}, {-0.05, -0.15, -1}, 28, 40)).refracted_rays;
  }
  CHECK(refracted > 50000);
}

TEST_CASE("packet: rays inside of many solids, and along the axes of boxes", "[packet]") {
  Scene s;
  Random random(2);
  s.settings.depth = 10;
  for (int i = 0; i < 7; ++i) add_sphere(s, {}, 0.4 + 0.2 * i, glass(random, false));  // one in another
  for (int i = 0; i < 4; ++i) {
    const double x = -3 + 2 * i;
    add_box(s, {x, -1, -1}, {x + 1, 1, 1}, glass(random, false));
    add_box(s, {x + 1, -1, -1}, {x + 2, 1, 1}, glass(random, true));  // side by side with it
  }
  s.lights.push_back(point_light({5, 8, 6}, 0.8));
  check_same(s, view({0, 0, 6}, {0, 0, -1}, 32));
  check_same(s, view({0.1, 0.2, 6}, {0, 0, -1}, 31));
  CHECK(check_same(s, view({9, 0.3, 0.1}, {-1, 0, 0}, 32)).refracted_rays > 1000);
}

TEST_CASE("packet: more rays than a block has room for are followed one by one", "[packet]") {
  Scene s;
  Material m = clear(0.9, 1.5);
  m.reflection.color = grey(0.3);
  for (int i = 0; i < 4; ++i) add_box(s, {-2, -2, -2.0 * i - 1}, {2, 2, -2.0 * i}, m);
  s.lights.push_back(point_light({5, 8, 6}, 0.8));
  s.settings.depth = 18;
  const Stats stats = check_same(s, view({0.3, 0.2, 6}, {0, 0, -1}, 8, 30));
  CHECK(stats.refracted_rays + stats.reflected_rays > 700000);
}

TEST_CASE("packet: log sums, and many lights where an error is asked for, go ray by ray", "[packet]") {
  const scene::View v = view({0, 0, 6}, {0, 0, -1});
  Scene s = balls_and_floor(3, 1);
  CHECK(plan(s, v, {}).packets);
  Options options;
  options.error = 0.01;
  CHECK(plan(s, v, options).packets);
  Scene lamps = s;
  while (lamps.lights.size() < 5) lamps.lights.push_back(point_light({0, 9, 0}));
  CHECK_FALSE(plan(lamps, v, options).packets);  // Which of them matter is seen ray by ray.
  options = {};
  options.skips = Skips::all().without(Skip::dark_lights);
  CHECK_FALSE(plan(s, v, options).packets);
  Scene log = s;
  log.settings.sum = scene::Sum::log;
  CHECK_FALSE(plan(log, v, {}).packets);
  add_box(s, {}, {1, 1, 1}, clear(0.5, 1.5));
  scene::View parallel = v;
  CHECK(plan(s, parallel, {}).packets);
  parallel.projection = scene::Projection::orthographic;
  CHECK_FALSE(plan(s, parallel, {}).packets);
}

TEST_CASE("packet: powers are those of single numbers", "[packet]") {
  const auto columns = std::make_unique<std::array<Numbers, 3>>();
  const auto certain = std::make_unique<Words>(), asked = std::make_unique<Words>();
  asked->at.fill(-1);
  auto& [x, y, out] = *columns;
  Random random(5);
  std::size_t sure = 0;
  for (int round = 0; round < 200; ++round) {
    for (std::size_t i = 0; i < k_wave; ++i) {
      x[i] = i % 4 == 0 ? random() : i % 4 == 1 ? 1 - random() * 1e-6 : std::exp2(60 * random() - 30);
      y[i] = i % 3 == 0 ? 50 : i % 3 == 1 ? 100 * random() : std::exp2(20 * random() - 10);
    }
    x[3] = 0, x[4] = 1, x[5] = 0x1p-1050, x[6] = k_infinity, x[7] = 0.5, y[8] = 0;
    LANCER_ON_TARGET(powers(x, y, *asked, out, *certain, k_wave));
    bool same = true;
    for (std::size_t i = 0; i < k_wave; ++i) {
      if ((*certain)[i] == 0) continue;
      ++sure;
      same = same && out[i] == math::pow(x[i], y[i]);
    }
    REQUIRE(same);
  }
  CHECK(sure > 120 * k_wave);
}

#if defined(LANCER_HAS_AVX2)
TEST_CASE("packet: with AVX2 and without, the same bits and the same work", "[packet]") {
  if (!k_use_avx2) return;
  struct Room {
    Vec3s origin, direction, point[2], normal[2];
    Numbers error, t[2], root_error[2];
    Column<std::uint32_t> primitive;
    Words exits, settled[2];
    FirstHits found[2];
  };
  const auto room = std::make_unique<Room>();
  for (const int count : {30, 300}) {
    const Scene s = balls_and_floor(count, 1);
    const World world = prepare(s);
    Plan needed;
    needed.shadows = ShadowWork::blocked;
    const PacketWorld packets(world, needed);
    Random random(3);
    for (std::size_t i = 0; i < k_wave; ++i) {
      room->origin.set(i, {0, 2, 6});
      room->direction.set(i, normalize(Vec3{0.5 * random() - 0.25, -0.1 - 0.5 * random(), -1}));
      room->error[i] = 0;
      room->exits[i] = 0;
    }
    const RaysView rays{&room->origin, &room->direction, nullptr, nullptr, nullptr, k_wave};
    Work work[2];
    baseline::find_closest(packets.scenery(), rays, room->found[0], work[0]);
    avx2::find_closest(packets.scenery(), rays, room->found[1], work[1]);
    CHECK(work[0].node_visits == work[1].node_visits);
    CHECK(work[0].shape_tests == work[1].shape_tests);
    const FirstHits &a = room->found[0], &b = room->found[1];
    std::size_t hits = 0;
    for (std::size_t i = 0; i < k_wave; ++i) {
      REQUIRE(a.seen[i] == b.seen[i]);
      if (a.seen[i] != Outlook::surface) continue;
      REQUIRE((a.primitive[i] == b.primitive[i] && a.t[i] == b.t[i] && a.error[i] == b.error[i] &&
               a.entering[i] == b.entering[i]));
      // Those on balls, one after the other.
      if (world.primitives[static_cast<std::size_t>(a.primitive[i])].kind != Kind::sphere) continue;
      room->primitive[hits] = static_cast<std::uint32_t>(a.primitive[i]);
      room->direction.set(hits, room->direction[i]);
      room->found[0].entering[hits] = a.entering[i];
      for (int k = 0; k < 2; ++k) {
        room->t[k][hits] = a.t[i];
        room->root_error[k][hits] = a.error[i];
      }
      ++hits;
    }
    REQUIRE(hits > 20);
    hits -= hits % 4;
    for (std::size_t k = 0; k < 2; ++k) {
      const LandingView view{&room->origin,
                             &room->direction,
                             &room->error,
                             room->primitive.at.data(),
                             &room->found[0].entering,
                             nullptr,
                             &room->exits,
                             0,
                             hits,
                             &room->t[k],
                             &room->root_error[k],
                             &room->point[k],
                             &room->normal[k],
                             &room->settled[k]};
      k == 0 ? baseline::land_on_spheres(packets.scenery(), view)
             : avx2::land_on_spheres(packets.scenery(), view);
    }
    for (std::size_t i = 0; i < hits; ++i) {
      REQUIRE(room->settled[0][i] == room->settled[1][i]);
      REQUIRE((room->t[0][i] == room->t[1][i] && room->root_error[0][i] == room->root_error[1][i]));
      REQUIRE((room->point[0][i] == room->point[1][i] && room->normal[0][i] == room->normal[1][i]));
    }
  }
}
#endif
