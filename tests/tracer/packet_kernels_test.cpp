// Kernels of rays that go together: with AVX2 and without, the same bits.

#include <bit>
#include <memory>

#include "catch.hpp"
#include "random_scene.hpp"
#include "tracer/packet/kernels.hpp"
#include "tracer/packet/scenery.hpp"

#if defined(LANCER_HAS_AVX2)

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// Two columns up to `count`; where `which` is given, only there.
bool same(const Numbers& a, const Numbers& b, std::size_t count, const Words* which = nullptr) {
  for (std::size_t i = 0; i < count; ++i) {
    if (which && (*which)[i] == 0) continue;
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  }
  return true;
}
bool same(const Words& a, const Words& b, std::size_t count, const Words* which = nullptr) {
  for (std::size_t i = 0; i < count; ++i) {
    if ((!which || (*which)[i] != 0) && a[i] != b[i]) return false;
  }
  return true;
}
bool same(const Vec3s& a, const Vec3s& b, std::size_t count, const Words* which = nullptr) {
  return same(a.x, b.x, count, which) && same(a.y, b.y, count, which) && same(a.z, b.z, count, which);
}
bool same(const Colors& a, const Colors& b, std::size_t count, const Words* which = nullptr) {
  return same(a.r, b.r, count, which) && same(a.g, b.g, count, which) && same(a.b, b.b, count, which);
}

Vec3 some_direction(Random& random) { return normalize(random.in_cube(1) + Vec3{1e-3, 0, 0}); }

/// Boxes and balls of glass, some opaque, one in another.
Scene solids(Random& random) {
  Scene s;
  for (int i = 0; i < 12; ++i) {
    const Material m = i % 4 == 3 ? matt(0.5) : clear(0.3 + 0.6 * random(), 1 + random());
    const Vec3 at = random.in_cube(1);
    const double r = 0.3 + 0.8 * random();
    if (i % 2 == 0) {
      add_sphere(s, at, r, m);
    } else {
      add_box(s, at - Vec3{r, r, r}, at + Vec3{r, 0.5 * r, r}, m,
              i % 3 == 0 ? rotation({30, 50 * random(), 10}) : Affine{});
    }
  }
  return s;
}

struct Room {
  Vec3s origin, direction, normal, bent[2];
  Colors share, reflection, transmission, reflected[2], transmitted[2];
  Numbers from, to, reflectance[2], distance, rise[2];
  Words all, fresnel, total[2], known[2], reflects[2], transmits[2], passes[2], inside[2], lit[2];
  FirstHits found[2];
  Exits exits[2];
  Starts starts;
  Column<Outlook> seen[2];
  Filters filters[2];
};

}  // namespace

TEST_CASE("packet: refraction and its shares are the same with AVX2 and without", "[packet]") {
  if (!k_use_avx2) return;
  const auto room = std::make_unique<Room>();
  Random random(11);
  for (std::size_t i = 0; i < k_wave; ++i) {
    room->direction.set(i, some_direction(random));
    const Vec3 n = some_direction(random);
    room->normal.set(i, dot(n, room->direction[i]) < 0 ? n : -n);
    room->from[i] = i % 5 == 0 ? 1.2 : 1 + random();
    room->to[i] = i % 5 == 0 ? 1.2 : 1 + random();
    room->share.set(i, {random(), random(), random()});
    room->reflection.set(i, i % 3 == 0 ? Color{} : grey(random()));
    room->transmission.set(i, i % 4 == 0 ? Color{} : Color{random(), random(), random()});
    room->fresnel[i] = i % 2 == 0 ? -1 : 0;
    room->all[i] = i % 7 == 0 ? 0 : -1;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const BentView bent{&room->all,     &room->direction, &room->normal,   &room->from,          &room->to,
                        &room->bent[k], &room->total[k],  &room->known[k], &room->reflectance[k]};
    CHECK((k == 0 ? baseline::bend(bent, k_wave) : avx2::bend(bent, k_wave)));
    const SharesView shares{
        &room->share,          &room->reflection,  &room->transmission,   &room->all,
        &room->fresnel,        &room->total[k],    &room->reflectance[k], &room->reflected[k],
        &room->transmitted[k], &room->reflects[k], &room->transmits[k]};
    k == 0 ? baseline::split(shares, k_wave) : avx2::split(shares, k_wave);
    const TurnedView turned{&room->bent[k], &room->normal,    &room->all,
                            &room->rise[k], &room->inside[k], &room->passes[k]};
    k == 0 ? baseline::turn(turned, k_wave) : avx2::turn(turned, k_wave);
  }
  Words bends = room->total[0];
  std::size_t total = 0;
  for (std::size_t i = 0; i < k_wave; ++i) {
    total += bends[i] != 0 ? 1 : 0;
    bends[i] = ~bends[i];
  }
  CHECK(total > k_wave / 20);
  CHECK(same(room->bent[0], room->bent[1], k_wave, &bends));
  CHECK(same(room->total[0], room->total[1], k_wave));
  CHECK(same(room->reflectance[0], room->reflectance[1], k_wave));
  CHECK(same(room->reflected[0], room->reflected[1], k_wave));
  CHECK(same(room->transmitted[0], room->transmitted[1], k_wave));
  CHECK(same(room->reflects[0], room->reflects[1], k_wave));
  CHECK(same(room->transmits[0], room->transmits[1], k_wave));
  CHECK(same(room->rise[0], room->rise[1], k_wave, &bends));
  CHECK(same(room->passes[0], room->passes[1], k_wave, &bends));
}

TEST_CASE("packet: rays in and out of solids are the same with AVX2 and without", "[packet]") {
  if (!k_use_avx2) return;
  const auto room = std::make_unique<Room>();
  Random random(12);
  std::uint64_t leave = 0, through = 0;
  for (int round = 0; round < 20; ++round) {
    const Scene s = solids(random);
    const World world = prepare(s);
    const PacketWorld packets(world, Plan{});
    for (std::size_t i = 0; i < k_wave; ++i) {
      room->origin.set(i, {0, 0.5, 6});
      room->direction.set(i, normalize(Vec3{0.4 * random() - 0.2, 0.4 * random() - 0.3, -1}));
      room->distance[i] = 4 * random();
      room->all[i] = -1;
    }
    const RaysView rays{&room->origin, &room->direction, nullptr, nullptr, nullptr, k_wave};
    Work work;
    baseline::find_closest(packets.scenery(), rays, room->found[0], work);
    avx2::find_closest(packets.scenery(), rays, room->found[1], work);
    Words met;
    for (std::size_t i = 0; i < k_wave; ++i) {
      REQUIRE(room->found[0].seen[i] == room->found[1].seen[i]);
      met[i] = room->found[0].seen[i] == Outlook::surface ? -1 : 0;
    }
    REQUIRE(same(room->found[0].primitive, room->found[1].primitive, k_wave, &met));
    REQUIRE(same(room->found[0].t, room->found[1].t, k_wave, &met));
    REQUIRE(same(room->found[0].error, room->found[1].error, k_wave, &met));

    // On from there, in any direction.
    std::size_t count = 0;
    for (std::size_t i = 0; i < k_wave; ++i) {
      if (met[i] == 0) continue;
      const std::uint32_t primitive = primitive_of(room->found[0].primitive[i]);
      const Root root{room->found[0].t[i], room->found[0].error[i], room->found[0].entering[i] != 0, false,
                      face_of(room->found[0].primitive[i])};
      const Landing landing = land(world, primitive, room->origin[i], room->direction[i], root);
      const Vec3 on = some_direction(random);
      room->origin.set(count, landing.point);
      room->direction.set(count, on);
      room->starts.error[count] = 1e-15;
      room->starts.primitive[count] = primitive;
      room->starts.shape[count] = world.primitives[primitive].shape;
      room->starts.rise[count] = std::fabs(dot(landing.normal, on));
      room->starts.passes[count] = dot(landing.normal, on) < 0 ? -1 : 0;
      room->starts.open[count] = 0;
      leave += room->starts.passes[count] != 0 ? 1 : 0;
      ++count;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const RaysView on{&room->origin, &room->direction, &room->starts, &room->exits[k], nullptr, count};
      const ShadowsView shadows{on, &room->all, &room->distance};
      const ShadowsSeen seen{&room->seen[k], &room->lit[k], &room->filters[k]};
      if (k == 0) {
        baseline::find_exits(packets.scenery(), on, nullptr, room->exits[k]);
        baseline::find_closest(packets.scenery(), on, room->found[k], work);
        baseline::find_blocked(packets.scenery(), shadows, seen, work);
      } else {
        avx2::find_exits(packets.scenery(), on, nullptr, room->exits[k]);
        avx2::find_closest(packets.scenery(), on, room->found[k], work);
        avx2::find_blocked(packets.scenery(), shadows, seen, work);
      }
    }
    REQUIRE(same(room->exits[0].t, room->exits[1].t, count, &room->starts.passes));
    REQUIRE(same(room->exits[0].error, room->exits[1].error, count, &room->starts.passes));
    REQUIRE(same(room->exits[0].primitive, room->exits[1].primitive, count, &room->starts.passes));
    REQUIRE(same(room->lit[0], room->lit[1], count));
    for (std::size_t i = 0; i < count; ++i) {
      REQUIRE(room->found[0].seen[i] == room->found[1].seen[i]);
      met[i] = room->found[0].seen[i] == Outlook::surface ? -1 : 0;
      REQUIRE(room->seen[0][i] == room->seen[1][i]);
      if (room->seen[0][i] != Outlook::nothing) continue;
      REQUIRE(room->filters[0].count[i] == room->filters[1].count[i]);
      for (std::size_t f = 0; f < room->filters[0].count[i]; ++f)
        REQUIRE(room->filters[0].crossed[i][f] == room->filters[1].crossed[i][f]);
      through += room->filters[0].count[i];
    }
    REQUIRE(same(room->found[0].primitive, room->found[1].primitive, count, &met));
    REQUIRE(same(room->found[0].t, room->found[1].t, count, &met));
    REQUIRE(same(room->found[0].error, room->found[1].error, count, &met));
  }
  CHECK(leave > 500);
  CHECK(through > 500);
}

#endif
