// The bits of what every kernel says, of which pictures are made: no compiler, no processor and no option may
// change one. A product and a sum that are contracted to one rounding do.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/format.h>

#include "stress/random.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/standard.hpp"
#include "stress/truth/reference/pictures.hpp"
#include "tracer/build.hpp"

namespace lancer::stress {
namespace {

/// A number for all that was added, in order.
class Digest {
 public:
  void add(std::uint64_t bits) { state_ = mix((state_ + bits) ^ std::rotl(state_, 23)); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(Vec3 v) {
    for (const double value : {v.x, v.y, v.z}) add(value);
  }
  void add(const tracer::Root& root) {
    add(root.t);
    add(root.error);
    add((root.entering ? std::uint64_t{1} : 0) + (root.loose ? 2U : 0U) + 4U * root.face);
  }
  void add(const tracer::Roots& roots) {
    add(static_cast<std::uint64_t>(roots.count) + (roots.passes ? 4U : 0U));
    for (int i = 0; i < roots.count; ++i) add(roots.root[i]);
  }
  void add(const tracer::Landing& landing) {
    add(landing.root);
    add(landing.rest);
    add(landing.tilt);
    add(landing.point);
    add(landing.normal);
  }
  void add(const tracer::Hit& hit) {
    add(hit.root);
    add(hit.point);
    add(hit.point_error);
    add(hit.normal);
    add((std::uint64_t{hit.primitive} << 32) + hit.contacts.size());
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 1;
};

enum Part : std::size_t { rays, crossings, landings, hits, k_parts };
constexpr std::array<const char*, k_parts> k_names{"rays", "crossings", "landings", "hits"};
using Digests = std::array<std::uint64_t, k_parts>;

/// A shape about 2 wide at the origin, put somewhere.
struct Kind {
  const char* name;
  void (*add)(scene::Scene&, Random&, const Affine&);
  bool stays = false;  // unturned
  Digests expected;
};

void add_ball(scene::Scene& s, Random& random, const Affine& map) {
  const Vec3 center = random.in_cube(0.1);
  tracer::test::add_sphere(s, center, random.between(0.8, 1), {}, map);
}
void add_ellipsoid(scene::Scene& s, Random& random, const Affine& map) {
  const Vec3 axes{random.over_scales(1e-3, 1), random.between(0.2, 1), random.between(0.5, 1)};
  tracer::test::add_sphere(s, random.in_cube(0.1), 1, {}, then(scaling(axes), map));
}
void add_plane(scene::Scene& s, Random& random, const Affine& map) {
  const Vec3 point = random.in_cube(0.5);
  tracer::test::add_plane(s, point, random.direction(), {}, map);
}
void add_level(scene::Scene& s, Random& random, const Affine& map) {
  tracer::test::add_plane(s, random.in_cube(0.5), {0, 1, 0}, {}, map);
}
void add_box(scene::Scene& s, Random& random, const Affine& map) {
  const double low = random.between(-1, -0.1), high = random.between(0.1, 1);
  tracer::test::add_box(s, {low, -1, low}, {high, high, 1}, {}, map);
}
void add_facet(scene::Scene& s, Random& random, const Affine& map) {
  const Vec3 a = random.in_cube(1), b = random.in_cube(1);
  tracer::test::add_facet(s, a, b, random.in_cube(1), {}, map);
}
void add_cube_mesh(scene::Scene& s, Random&, const Affine& map) {
  tracer::test::add_mesh(s, tracer::test::cube_mesh(true), {}, map);
}

const Kind k_kinds[] = {
    {"sphere",
     add_ball,
     false,
     {0x9953c86b00046640, 0xc08c975e54dafade, 0xdb159189a32b615d, 0xe07d7b37fae63eec}},
    {"ellipsoid",
     add_ellipsoid,
     false,
     {0x12c2fe150b4e7983, 0xb29997625d214ff8, 0x4e067d29358643c1, 0x55ab4871005af848}},
    {"plane",
     add_plane,
     false,
     {0xeaca709205223cf2, 0x6ea6a587b69eb75c, 0x4d191179f821ad56, 0x7718cfcb8a0eec4f}},
    {"level plane",
     add_level,
     true,
     {0xada5d142e3318158, 0x0e8cce7ab0d69f23, 0xd2a3a5c71f49f2b1, 0xe5fd38f3ef677749}},
    {"box", add_box, true, {0x60894606b5b5abb8, 0x4424309b946174a6, 0x869b6f663b300e05, 0xc5340661c0923644}},
    {"turned box",
     add_box,
     false,
     {0x1f3cac695fdf368b, 0x284cce16d232c67c, 0xeed3bff573c12488, 0xfa0385afc59b834b}},
    {"facet",
     add_facet,
     false,
     {0xcf7e0a3bb1176a36, 0x838d83a5ae57c533, 0x2080b5257af8bde8, 0xe96647091c311345}},
    {"mesh",
     add_cube_mesh,
     false,
     {0xad25d55e04b53da7, 0xdde3aba2d65a4008, 0xcf80be5430559888, 0xd1595f9ce39f07a2}},
};

/// From any direction and distance at the shape, past it, or all but along one of its sides.
tracer::Ray ray_at(Random& random, const Affine& map) {
  const double distance = random.over_scales(1, 1e4);
  const Vec3 from = random.direction() * distance, aside = random.across(from);
  Vec3 target = random.in_cube(1.2);
  if (random.below(4) == 0) target = aside * (1 + random.signed_over_scales(1e-16, 1e-2));
  if (random.below(4) == 0) target.y = random.below(3) - 1;
  tracer::Ray ray;
  ray.origin = map.point(from);
  ray.direction = normalize(map.point(target) - ray.origin);
  return ray;
}

/// All that a world tells of a ray: where it crosses every primitive, the first hit, and what a ray that is
/// mirrored there hits and one that goes on.
void tell(const tracer::World& world, const tracer::Ray& ray, std::array<Digest, k_parts>& digests) {
  digests[rays].add(ray.origin);
  digests[rays].add(ray.direction);
  const tracer::Probe probe(ray);
  for (std::uint32_t i = 0; i < world.primitives.size(); ++i) {
    const tracer::Roots found = roots(world, i, probe);
    digests[crossings].add(found);
    for (int k = 0; k < found.count; ++k) {
      if (found.root[k].t > 0)
        digests[landings].add(land(world, i, ray.origin, ray.direction, found.root[k]));
    }
  }
  tracer::Stats stats;
  tracer::Hit hit, next;
  if (!closest(world, ray, stats, hit)) return;
  digests[hits].add(hit);
  const Vec3 mirrored = normalize(ray.direction - hit.normal * (2 * dot(hit.normal, ray.direction)));
  for (const Vec3 direction : {mirrored, ray.direction}) {
    if (closest(world, ray_from(world, hit, direction), stats, next)) digests[hits].add(next);
  }
}

Digests digests_of(const Kind& kind) {
  constexpr std::uint64_t k_worlds = 150;
  constexpr int k_rays = 24;
  std::array<Digest, k_parts> digests;
  for (std::uint64_t i = 0; i < k_worlds; ++i) {
    // The seed is fixed, for the digests are.
    Random random(1, std::string("kernels.bits/") + kind.name, i);
    const double size = random.over_scales(1e-9, 1e9), away = random.below(2) == 0 ? 0 : 100;
    const Affine turn = kind.stays ? Affine{} : rotation(random.in_cube(180));
    const Affine scaled = then(turn, scaling({size, size, size}));
    const Affine map = then(scaled, translation(random.in_cube(away) * size));
    scene::Scene scene;
    kind.add(scene, random, map);
    const tracer::World world = tracer::prepare(scene);
    for (int ray = 0; ray < k_rays; ++ray) tell(world, ray_at(random, map), digests);
  }
  Digests values{};
  std::transform(digests.begin(), digests.end(), values.begin(), [](const Digest& d) { return d.value(); });
  return values;
}

/// A scene of every kind, drawn: the camera, materials, lights and media, too.
std::uint64_t digest_of_picture() {
  const Script script(Standard{1, {}}.text(40));
  Digest digest;
  for (const Color& c : drawn(script.scene, script.view)) digest.add(Vec3{c.r, c.g, c.b});
  return digest.value();
}
constexpr std::uint64_t k_picture = 0x6866a1e1cc7082d7;

Outcome bits(const Settings&) {
  Outcome out;
  const auto check = [&out](const std::string& what, std::uint64_t found, std::uint64_t expected) {
    out.limits.push_back({"other bits of " + what, found == expected ? 0.0 : 1.0, 0});
    if (found != expected) out.note += fmt::format("{} {:#018x}; ", what, found);
  };
  for (const Kind& kind : k_kinds) {
    const Digests found = digests_of(kind);
    for (std::size_t part = 0; part < k_parts; ++part)
      check(fmt::format("{}, {}", kind.name, k_names[part]), found[part], kind.expected[part]);
  }
  check("a picture", digest_of_picture(), k_picture);
  return out;
}

}  // namespace

void add_kernels_bits_rows(Rows& rows) {
  rows.push_back({"kernels.bits",
                  "the bits of crossings, landings, hits and a picture, which no compiler may change", bits});
}

}  // namespace lancer::stress
