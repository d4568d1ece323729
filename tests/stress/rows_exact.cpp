// Rays and points for which only exact answers are right: slopes that all but cancel, ways out through edges,
// hits exactly on the edges of a mesh, points on surfaces, and faces in the boundaries of a pattern's cells.

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

#include "stress/contest.hpp"
#include "stress/exact_sign.hpp"
#include "stress/harness.hpp"
#include "stress/methods_plane.hpp"
#include "stress/oracle_box.hpp"
#include "tracer/build.hpp"
#include "tracer/media.hpp"
#include "tracer/shadow.hpp"
#include "tracer/surface.hpp"

namespace lancer::stress::flat {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// What came out of many questions that have one right answer each.
class Judgement {
 public:
  Judgement() {
    measure_.method = "in use";
    measure_.in_use = true;
  }
  /// `told` makes the text that says how to ask again.
  template <class Told>
  bool check(bool right, const char* set, Told told) {
    ++measure_.rays;
    if (!right) note_of(measure_.wrong, set, told);
    return right;
  }
  template <class Told>
  void check_start(bool met, const char* set, Told told) {
    ++measure_.rays;
    if (met) note_of(measure_.self_hits, set, told);
  }
  void add_distance(double error) { distances_.add(error); }

  Outcome outcome() const {
    Outcome out;
    Measure measure = measure_;
    measure.distance_max = distances_.largest();
    measure.distance_999 = distances_.at(0.999);
    out.measures.push_back(measure);
    if (distances_.count() > 0) out.limits.push_back({"distance, ulp", measure.distance_max, 1});
    out.limits.push_back({"wrong", static_cast<double>(measure.wrong), 0});
    out.limits.push_back({"self-hits", static_cast<double>(measure.self_hits), 0});
    out.note = note_;
    return out;
  }

 private:
  template <class Told>
  void note_of(std::uint64_t& count, const char* set, Told told) {
    ++count;
    if (!note_.empty()) return;
    measure_.set = set;
    note_ = fmt::format("{}: {}", set, told());
  }

  Measure measure_;
  Errors distances_;
  std::string note_;
};

/// Turned, and moved by up to `away`.
Affine turned(Random& random, double away) {
  const Vec3 angles = random.in_cube(180), by = random.in_cube(away);
  return then(rotation(angles), translation(by));
}

std::string told(Vec3 origin, Vec3 direction) {
  return fmt::format("origin {} direction {}", exactly(origin), exactly(direction));
}

// --- plane.exact

/// Doubles n, some 2^52 long, and d, one long, whose product all but cancels.
struct Across {
  Vec3 n, d;
};

/// x with x a = 1 modulo b, both without a common divisor; 0: they have one.
boost::multiprecision::cpp_int inverse_of(boost::multiprecision::cpp_int a,
                                          boost::multiprecision::cpp_int b) {
  boost::multiprecision::cpp_int x = 1, next = 0;
  while (b != 0) {
    const boost::multiprecision::cpp_int times = a / b, rest = a - times * b, after = x - times * next;
    a = b;
    b = rest;
    x = next;
    next = after;
  }
  return a == 1 ? x : 0;
}

/// n . d is `target` times some 2^-78, exactly. With whole numbers d = (x, y, z 2^-s) 2^-53 this asks for
/// x a + y b + z c 2^-s = target 2^-s: c follows modulo 2^s, then a modulo y, then b.
Across all_but_orthogonal(Random& random, int target) {
  using Whole = boost::multiprecision::cpp_int;
  constexpr int k_digits = 53;
  for (;;) {
    const double along = random.between(0.69, 0.73), beside = random.between(0.69, 0.73);
    const Vec3 d = normalize(Vec3{along, beside, random.between(0.55, 0.9) * 0x1p-24});
    const int s = -1 - std::ilogb(d.z);
    const auto x = static_cast<std::uint64_t>(std::ldexp(d.x, k_digits));
    const auto y = static_cast<std::uint64_t>(std::ldexp(d.y, k_digits));
    const auto z = static_cast<std::uint64_t>(std::ldexp(d.z, k_digits + s));
    const Whole inverse = inverse_of(x, y);
    if (z % 2 == 0 || inverse == 0) continue;
    std::uint64_t inverse_z = z;  // modulo 8, then modulo 2^6, 2^12, ...
    for (int i = 0; i < 5; ++i) inverse_z *= 2 - z * inverse_z;
    const std::uint64_t low = static_cast<std::uint64_t>(target) * inverse_z & ((std::uint64_t{1} << s) - 1);
    const std::uint64_t c = low + (random.bits() >> (64 - 52 + s) << s);
    const Whole sum = (Whole(target) - Whole(z) * c) / (Whole(1) << s);
    Whole a = inverse * sum % y;
    if (a < 0) a += y;
    const Whole b = (sum - a * x) / y;
    if (abs(b) >= (Whole(1) << k_digits)) continue;
    return {{a.convert_to<double>(), b.convert_to<double>(), static_cast<double>(c)}, d};
  }
}

RaySet cancelling(const std::string& name, bool depth, std::vector<int> targets) {
  return {name, [=](Random& random, int shots) {
            const int target = targets[static_cast<std::size_t>(random.below(int(targets.size())))];
            const Across across = all_but_orthogonal(random, target);
            Batch batch;
            batch.scene = std::make_unique<scene::Scene>();
            tracer::test::add_plane(*batch.scene, {}, across.n);
            batch.world = tracer::prepare(*batch.scene);
            for (int i = 0; i < shots; ++i) {
              Shot shot;
              const double sign = random.sign(), size = random.signed_over_scales(0.1, 10);
              shot.ray.origin =
                  depth ? across.d * std::scalbn(sign, random.below(9) - 4) : normalize(across.n) * size;
              shot.ray.direction = depth ? random.direction() : across.d * sign;
              batch.shots.push_back(shot);
            }
            return batch;
          }};
}

Outcome plane_exact(const Settings& settings) {
  std::vector<Method> methods = plane_methods();
  for (Method& method : methods_in_use()) methods.push_back(std::move(method));
  const std::vector<int> targets{1, -1, 3, -3, 256, -256};
  return measure(settings, "plane.exact",
                 {cancelling("slopes", false, targets), cancelling("along it", false, {0}),
                  cancelling("heights", true, targets), cancelling("starts on it", true, {0})},
                 methods, [](const tracer::World& world, const Sight& sight) {
                   return stress::first_hit(world.planes.at(0), sight);
                 });
}

// --- box.exits

BoxNumbers numbers(const tracer::BoxPrimitive& b) { return {b.lo, b.hi, !b.aligned, b.center, b.to_own}; }

/// In by a side, at `start`, then towards `target`, both in the space of the box.
struct Passage {
  Vec3 lo, hi, start, target;
  int axis = 0;
};

/// From the lower side to an edge or corner, or `beside` it.
Passage to_rim(Random& random, bool corner, double beside) {
  Passage out;
  for (int i = 0; i < 3; ++i) {
    out.hi[i] = random.between(0.5, 2);
    out.lo[i] = -out.hi[i];
    out.start[i] = out.hi[i] * random.between(-0.9, 0.9);
    out.target[i] = out.hi[i] * random.between(-0.9, 0.9);
  }
  out.axis = random.below(3);
  out.start[out.axis] = out.lo[out.axis];
  out.target[out.axis] = out.hi[out.axis];
  for (int k = 1; k <= (corner ? 2 : 1); ++k) {
    const int next = (out.axis + k) % 3;
    out.target[next] = random.below(2) == 0 ? out.lo[next] : out.hi[next];
  }
  if (beside > 0) {
    for (int i = 0; i < 3; ++i) out.target[i] += random.signed_over_scales(beside * 1e-3, beside);
  }
  return out;
}

/// Along a diagonal, of which two or all three components are equal: several sides are met at the very same
/// distance.
Passage along_diagonal(Random& random, bool corner) {
  Passage out;
  out.axis = random.below(3);
  const double width = 1 + random.below(16) / 8.0;
  Vec3 way;
  for (int i = 0; i < 3; ++i) {
    const bool shared = corner || i == out.axis || i == (out.axis + 1) % 3;
    const double more = i == out.axis ? 0 : 0.5 + random.below(8) / 8.0;
    out.lo[i] = random.below(64) / 8.0 - 4;
    out.hi[i] = out.lo[i] + width + more;
    way[i] = shared ? 1 : random.below(7) / 8.0;
    if (i != out.axis) way[i] *= random.sign();
    const bool back = way[i] < 0;
    out.start[i] = i == out.axis ? out.lo[i] : back ? out.lo[i] + width : out.hi[i] - width;
  }
  out.target = out.start + way * width;
  return out;
}

Outcome exits(const Settings& settings) {
  const std::uint64_t count = settings.full ? 20000 : 600;
  Record record("in use", true);
  Outcome out;
  const auto run = [&](const std::string& set, bool is_turned,
                       const std::function<Passage(Random&)>& passage_of) {
    for (std::uint64_t i = 0; i < count; ++i) {
      Random random(settings.seed, "box.exits/" + set, i);
      const Passage passage = passage_of(random);
      const Affine map = is_turned ? turned(random, random.below(2) == 0 ? 0 : 9) : Affine{};
      scene::Scene scene;
      tracer::test::add_box(scene, passage.lo, passage.hi, {}, map);
      const tracer::World world = tracer::prepare(scene);
      Vec3 ahead;
      ahead[passage.axis] = 1;
      tracer::Ray first;
      first.origin = map.point(passage.start - ahead);
      first.direction = normalize(map.vector(ahead));
      tracer::Stats stats;
      tracer::Hit hit, end;
      if (!closest(world, first, stats, hit)) throw std::runtime_error("a ray misses the box ahead");
      const tracer::Ray ray = ray_from(world, hit, normalize(map.point(passage.target) - hit.point));
      const Truth truth = box_way_out(numbers(world.boxes[0]), ray.origin, ray.direction);
      Reported got;
      got.hit = closest(world, ray, stats, end);
      if (got.hit) got = {true, end.root.t, end.point, end.normal, end.root.face, end.root.entering};
      if (!record.add(set, truth, got) && out.note.empty())
        out.note = fmt::format("{}: side {} for {}, lo {} hi {} {}", set, got.face, truth.face,
                               exactly(passage.lo), exactly(passage.hi), told(ray.origin, ray.direction));
    }
  };
  for (const bool is_turned : {false, true}) {
    const std::string way = is_turned ? "turned, " : "aligned, ";
    for (const bool corner : {false, true}) {
      const std::string rim = corner ? "corner" : "edge";
      run(way + "by the " + rim, is_turned, [=](Random& random) { return to_rim(random, corner, 0); });
      for (const double beside : {1e-15, 1e-9})
        run(fmt::format("{}{:.0e} beside the {}", way, beside, rim), is_turned,
            [=](Random& random) { return to_rim(random, corner, beside); });
      run(way + "along a diagonal to the " + rim, is_turned,
          [=](Random& random) { return along_diagonal(random, corner); });
    }
  }
  out.measures.push_back(record.measure());
  add_limits(out, out.measures.back());
  return out;
}

// --- mesh.edges

constexpr std::uint32_t k_cube = 0;

/// The cube [-1, 1]^3 as a solid mesh of twelve facets, of glass that keeps half.
struct FacetCube {
  Affine map;
  scene::Scene scene;
  tracer::World world;

  explicit FacetCube(const Affine& placed) : map(placed) {
    tracer::test::add_mesh(scene, tracer::test::cube_mesh(true), tracer::test::clear(0.5, 1), map);
    world = tracer::prepare(scene);
  }
};

/// A ray that meets the cube at `at`, in its own space.
struct Arrival {
  Vec3 at, way;
  bool inside = false;  // it starts within

  /// Does a direction lead into the cube from there?
  bool goes_in(Vec3 d) const {
    for (int i = 0; i < 3; ++i) {
      if (std::fabs(at[i]) == 1 && !(d[i] * at[i] < -1e-3)) return false;
    }
    return true;
  }
};

/// Exactly through an edge or corner, in numbers that are exact.
Arrival at_rim(Random& random, bool inside) {
  Arrival out;
  out.inside = inside;
  for (int i = 0; i < 3; ++i) out.at[i] = random.sign();
  const int axis = random.below(3);
  for (int i = 0; i < 3; ++i) out.way[i] = -out.at[i];
  out.way[axis] = (random.below(9) - 4) / 4.0;
  if (random.below(3) > 0) out.at[axis] = (random.below(15) - 7) / 8.0;
  if (inside) out.way = -out.way;
  // Within, the start is half a step back.
  if (inside && std::fabs(out.at[axis] - out.way[axis] / 2) >= 1) out.way[axis] = 0;
  if (inside && std::fabs(out.at[axis]) == 1) out.way[axis] = out.at[axis];
  return out;
}

/// Exactly through a diagonal of a side or what would be the other one.
Arrival at_diagonal(Random& random, bool inside) {
  Arrival out;
  out.inside = inside;
  const int axis = random.below(3), j = (axis + 1) % 3, k = (axis + 2) % 3;
  const double side = random.sign(), place = (random.below(13) - 6) / 8.0;
  out.at[axis] = side;
  out.at[j] = place;
  out.at[k] = place * random.sign();
  out.way[axis] = inside ? side : -side;
  if (random.below(2) == 0) out.way[j] = random.below(2) / 16.0;
  return out;
}

/// Next to the edge only.
Arrival near_rim(Random& random, bool inside) {
  Arrival out = at_rim(random, inside);
  const double far = random.between(2, 4);
  const Vec3 from = inside ? random.in_cube(0.5) : out.at * far + random.in_ball() * 0.5;
  out.way = (out.at - from) * (inside ? 2 : 0.5);  // as of the others, the start is half or two steps back
  return out;
}

Vec3 onwards(Random& random, const tracer::Ray& ray, Vec3 normal, int sort) {
  const Vec3 d = random.direction();
  if (sort == 0) return normalize(ray.direction - normal * (2 * dot(ray.direction, normal)));
  if (sort == 1) return ray.direction;
  if (sort > 2) return d;
  return normalize(d - normal * dot(d, normal) + normal * (random.sign() * 1e-6));  // all but along it
}

Real farthest(const tracer::World& world, const tracer::Ray& ray) {
  Real t = 0;
  for (const tracer::FacetPrimitive& f : world.facets) {
    const Truth one = facet_truth({f.a, f.b, f.c, f.flipped}, ray.origin, ray.direction);
    if (one.hit && one.t > t) t = one.t;
  }
  return t;
}

double light(const FacetCube& cube, const tracer::Ray& ray) {
  tracer::Stats stats;
  return light_through(cube.world, tracer::ShadowWork::filtered, ray, k_infinity, stats).r;
}

/// From where a ray met the cube: nothing outwards, the far side inwards, and the light that comes that way.
void go_on(Judgement& judgement, const char* set, const FacetCube& cube, const Arrival& arrival,
           const tracer::Hit& hit, Vec3 d) {
  tracer::Ray ray = ray_from(cube.world, hit, d);
  const bool outwards = dot(d, hit.normal) > 0;
  if (!outwards) ray.open.push_back(k_cube);
  const auto text = [&] { return "going on, " + told(ray.origin, ray.direction); };
  tracer::Stats stats;
  tracer::Hit next;
  if (outwards) {
    judgement.check_start(closest(cube.world, ray, stats, next), set, text);
    judgement.check(light(cube, ray) == 1, set, text);
  } else if (arrival.goes_in(inverse(cube.map)->vector(d))) {
    const bool found = closest(cube.world, ray, stats, next);
    if (!judgement.check(found && !next.root.entering && next.root.t > 1e-4, set, text)) return;
    judgement.add_distance(ulps(next.root.t, farthest(cube.world, ray)));
    judgement.check(light(cube, ray) == 0.5, set, text);
  }
}

void visit(Judgement& judgement, const char* set, const FacetCube& cube, const Arrival& arrival,
           Random& random) {
  tracer::Ray ray;
  ray.origin = cube.map.point(arrival.at - arrival.way * (arrival.inside ? 0.5 : 2));
  const bool exact = cube.map == Affine{};
  ray.direction = normalize(exact ? arrival.way : cube.map.point(arrival.at) - ray.origin);
  if (arrival.inside) ray.open.push_back(k_cube);
  const auto text = [&] { return told(ray.origin, ray.direction); };
  tracer::Stats stats;
  tracer::Hit hit;
  const bool found = closest(cube.world, ray, stats, hit);
  if (!exact && !found) return;  // past the edge, for rounding
  if (!judgement.check(found && hit.root.entering != arrival.inside, set, text)) return;
  if (exact && (arrival.inside || arrival.goes_in(arrival.way)))
    judgement.check(light(cube, ray) == (arrival.inside ? 0.5 : 0.25), set, text);
  for (int sort = 0; sort < 6; ++sort)
    go_on(judgement, set, cube, arrival, hit, onwards(random, ray, hit.normal, sort));
}

/// An open mesh of two sheets: from the front of the lower to the back of the upper.
void between_sheets(Judgement& judgement, const Settings& settings) {
  scene::Scene scene;
  scene::Mesh sheets;
  sheets.points = {{-2, 0, -2}, {2, 0, -2}, {0, 0, 2}, {-2, 1, -2}, {2, 1, -2}, {0, 1, 2}};
  sheets.faces = {{0, 2, 1}, {3, 5, 4}};
  tracer::test::add_mesh(scene, sheets);
  const tracer::World world = tracer::prepare(scene);
  for (std::uint64_t i = 0; i < 500; ++i) {
    Random random(settings.seed, "mesh.edges/sheets", i);
    const auto way = [&](double up) {
      const Vec3 aside = random.in_cube(0.3);
      return normalize(Vec3{aside.x, up, aside.z});
    };
    tracer::Ray ray;
    ray.origin = Vec3{0, 0.5, -0.3} + random.in_cube(0.3);
    ray.direction = way(-1);
    tracer::Stats stats;
    tracer::Hit hit, next;
    const bool found = closest(world, ray, stats, hit) &&
                       closest(world, ray_from(world, hit, way(1)), stats, next) &&
                       next.root.entering == false && hit.root.entering;
    judgement.check(found, "sheets", [&] { return told(ray.origin, ray.direction); });
  }
}

Outcome edges(const Settings& settings) {
  const std::uint64_t cubes = settings.full ? 300 : 12, rays = settings.full ? 400 : 60;
  Judgement judgement;
  struct Sort {
    const char* name;
    bool moved;
    Arrival (*make)(Random&, bool);
  };
  for (const Sort& sort : {Sort{"at the rim", false, at_rim}, Sort{"at a diagonal", false, at_diagonal},
                           Sort{"next to the rim", true, near_rim}}) {
    for (std::uint64_t i = 0; i < cubes; ++i) {
      Random random(settings.seed, std::string("mesh.edges/") + sort.name, i);
      const Affine map = sort.moved ? turned(random, i % 2 == 0 ? 9 : 9e4) : Affine{};
      const FacetCube cube(map);
      for (std::uint64_t ray = 0; ray < rays; ++ray) {
        const Arrival arrival = sort.make(random, random.below(2) == 0);
        visit(judgement, sort.name, cube, arrival, random);
      }
    }
  }
  between_sheets(judgement, settings);
  return judgement.outcome();
}

// --- media.sides

template <class Number>
Triple<Number> mapped(const tracer::Rows& rows, Vec3 center, Vec3 p) {
  const Triple<Number> offset = as<Number>(p) - as<Number>(center);
  return {dot(as<Number>(rows[0]), offset), dot(as<Number>(rows[1]), offset),
          dot(as<Number>(rows[2]), offset)};
}

int true_side(const tracer::SpherePrimitive& s, Vec3 p) {
  return exact_sign([&]<class Number>(Number) {
    const Triple<Number> offset = as<Number>(p) - as<Number>(s.center);
    return Number(dot(offset, offset) - Number(s.radius) * Number(s.radius));
  });
}
int true_side(const tracer::EllipsoidPrimitive& e, Vec3 p) {
  return exact_sign([&]<class Number>(Number) {
    const Triple<Number> own = mapped<Number>(e.to_own, e.center, p);
    return Number(dot(own, own) - Number(1));
  });
}
int true_side(const tracer::PlanePrimitive& plane, Vec3 p) {
  return exact_sign([&]<class Number>(Number) {
    const Triple<Number> offset = as<Number>(p) - as<Number>(plane.point);
    return Number(dot(as<Number>(plane.normal), offset) - Number(plane.level));
  });
}
int true_side(const tracer::BoxPrimitive& box, Vec3 p) {
  int side = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto past = [&](bool upper) {
      return exact_sign([&]<class Number>(Number) {
        const Number place = box.aligned ? Number(p[axis]) : mapped<Number>(box.to_own, box.center, p)[axis];
        return upper ? Number(place - Number(box.hi[axis])) : Number(Number(box.lo[axis]) - place);
      });
    };
    side = std::max({side, past(false), past(true)});
  }
  return side;
}
int true_side(const tracer::World& world, Vec3 p) {
  switch (world.primitives[0].kind) {
    case tracer::Kind::sphere: return true_side(world.spheres[0], p);
    case tracer::Kind::ellipsoid: return true_side(world.ellipsoids[0], p);
    case tracer::Kind::plane: return true_side(world.planes[0], p);
    case tracer::Kind::box: return true_side(world.boxes[0], p);
    case tracer::Kind::facet: break;
  }
  return 0;
}

int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

constexpr const char* k_solids[] = {"sphere", "ellipsoid", "plane", "turned box", "box"};

void add_solid(scene::Scene& scene, int kind, Random& random) {
  using namespace tracer::test;
  const Vec3 center = random.in_cube(2), sizes = Vec3{1.1, 1.1, 1.1} + random.in_cube(0.9);
  const Affine map = then(scaling(sizes), turned(random, 9));
  switch (kind) {
    case 0: add_sphere(scene, center, random.between(0.1, 3)); break;
    case 1: add_sphere(scene, {}, 1, {}, map); break;
    case 2: add_plane(scene, center, random.direction()); break;
    case 3: add_box(scene, {-1, -1, -1}, {1, 1, 1}, {}, map); break;
    default: add_box(scene, center - sizes, center + sizes); break;
  }
}

void check_side(Judgement& judgement, const char* set, const tracer::World& world, Vec3 p) {
  const int truth = true_side(world, p);
  const auto text = [&] { return fmt::format("at {}, in truth {}", exactly(p), truth); };
  judgement.check(sign_of(side(world, 0, p)) == truth, set, text);
  const std::vector<tracer::Surrounding> around = solids_around(world, p);
  const bool listed = truth > 0 ? around.empty() : around.size() == 1 && around[0].touched == (truth == 0);
  judgement.check(listed, set, text);
}

/// Points within a few steps of the doubles of a surface.
void next_to_surfaces(Judgement& judgement, const Settings& settings) {
  const std::uint64_t worlds = settings.full ? 20000 : 500;
  for (std::uint64_t i = 0; i < worlds; ++i) {
    Random random(settings.seed, "media.sides", i);
    const int kind = static_cast<int>(i % 5);
    scene::Scene scene;
    add_solid(scene, kind, random);
    const tracer::World world = tracer::prepare(scene);
    for (int k = 0; k < 10; ++k) {
      const double distance = random.between(1, 20);
      const int face = random.below(6);
      Vec3 p = project(world, 0, random.direction() * distance, face);
      for (int axis = 0; axis < 3; ++axis) {
        for (int steps = random.below(4); steps > 0; --steps)
          p[axis] = std::nextafter(p[axis], random.sign() * k_infinity);
      }
      check_side(judgement, k_solids[kind], world, p);
    }
  }
}

/// Off by less than twice the precision shows.
void beyond_twice_the_precision(Judgement& judgement, const Settings& settings) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Random random(settings.seed, "media.sides/beyond", i);
    scene::Scene with_plane, with_sphere;
    const Across across = all_but_orthogonal(random, random.below(5) - 2);
    tracer::test::add_plane(with_plane, {}, across.n);
    check_side(judgement, "plane, beyond", tracer::prepare(with_plane), across.d * random.sign());
    // (3 + 4 e)^2 + (4 - 3 e)^2 = 25 + 25 e^2.
    const double e = std::scalbn(1.0, -50 - random.below(350)), x = random.sign(), y = random.sign();
    tracer::test::add_sphere(with_sphere, Vec3{-4 * x, 3 * y, 0} * e, 5);
    check_side(judgement, "sphere, beyond", tracer::prepare(with_sphere), {3 * x, 4 * y, 0});
  }
}

/// An eye exactly on a solid is in it where it looks into it.
void eyes_on_surfaces(Judgement& judgement, const Settings& settings) {
  struct Place {
    const char* name;
    Vec3 at;
    std::vector<Vec3> normals;  // of all surfaces there
  };
  const std::vector<std::pair<int, Place>> places = {
      {0, {"eye on a sphere", {1, 2, 2}, {{1, 2, 2}}}},
      {0, {"eye on a sphere", {-3, 0, 0}, {{-1, 0, 0}}}},
      {1, {"eye on a side", {0.25, 1, 0.125}, {{0, 1, 0}}}},
      {1, {"eye on an edge", {-1, 1, 0.125}, {{0, 1, 0}, {-1, 0, 0}}}},
      {1, {"eye on a corner", {-1, 1, 1}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}},
      {2, {"eye on a plane", {3, -1, 0}, {{1, 2, 2}}}}};
  for (const auto& [kind, place] : places) {
    scene::Scene scene;
    if (kind == 0) tracer::test::add_sphere(scene, {}, 3);
    if (kind == 1) tracer::test::add_box(scene, {-1, -1, -1}, {1, 1, 1});
    if (kind == 2) tracer::test::add_plane(scene, {1, 0, 0}, {1, 2, 2});
    const tracer::World world = tracer::prepare(scene);
    const Vec3 at = place.at;
    const std::vector<tracer::Surrounding> around = solids_around(world, at);
    for (std::uint64_t i = 0; i < 400; ++i) {
      Random random(settings.seed, std::string("media.sides/") + place.name, i);
      const Vec3 d = random.direction();
      bool inside = true;
      for (const Vec3 n : place.normals) {
        inside =
            inside && exact_sign([&]<class Number>(Number) { return dot(as<Number>(n), as<Number>(d)); }) < 0;
      }
      tracer::Stats stats;
      const bool opened = open_at(world, around, at, d, stats).size() == 1;
      judgement.check(opened == inside, place.name, [&] { return told(at, d); });
    }
  }
}

/// Of two solids around the eye, that which is left last is the outer one, however near they are.
void nested_eyes(Judgement& judgement, const Settings& settings) {
  for (const bool larger : {false, true}) {
    scene::Scene scene;
    tracer::test::add_sphere(scene, {}, 1);
    tracer::test::add_sphere(scene, {}, larger ? 1 + 1e-14 : 1 - 1e-14);
    const tracer::World world = tracer::prepare(scene);
    for (std::uint64_t i = 0; i < (settings.full ? 100000U : 4000U); ++i) {
      Random random(settings.seed, "media.sides/nested", i);
      const double from_middle = random.between(0, 0.95);
      const Vec3 origin = random.direction() * from_middle, d = random.direction();
      tracer::Stats stats;
      const tracer::OpenSolids open = open_at(world, solids_around(world, origin), origin, d, stats);
      const bool right = open.size() == 2 && open[0] == (larger ? 1U : 0U);
      judgement.check(right, "spheres 1e-14 apart", [&] { return told(origin, d); });
    }
  }
}

/// Points on the axes of an octahedron and beside them: no ray along an axis tells in from out there.
void within_octahedron(Judgement& judgement) {
  scene::Scene scene;
  scene::Mesh mesh;
  mesh.solid = true;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  tracer::test::add_mesh(scene, mesh);
  const tracer::World world = tracer::prepare(scene);
  for (int eighth = -12; eighth <= 12; ++eighth) {
    for (const Vec3 beside : {Vec3{0, 0, 0}, Vec3{0, 0.25, 0}, Vec3{0, 0, 0.25}}) {
      const Vec3 p = beside + Vec3{eighth / 8.0, 0, 0};
      const double size = std::fabs(p.x) + p.y + p.z;
      if (size == 1) continue;
      judgement.check((side(world, 0, p) < 0) == (size < 1), "octahedron", [&] { return exactly(p); });
    }
  }
}

Outcome sides(const Settings& settings) {
  Judgement judgement;
  next_to_surfaces(judgement, settings);
  beyond_twice_the_precision(judgement, settings);
  eyes_on_surfaces(judgement, settings);
  nested_eyes(judgement, settings);
  within_octahedron(judgement);
  return judgement.outcome();
}

// --- picture.patterns

scene::Material patterned(scene::Scene& scene, scene::Pattern::Kind kind, double size, Vec3 axis) {
  scene::Pattern pattern;
  pattern.kind = kind;
  pattern.a = grey(0.9);
  pattern.b = grey(0.3);
  pattern.size = size;
  pattern.axis = axis;
  scene.patterns.push_back(pattern);
  scene::Material material = tracer::test::black();
  material.ambient.pattern = static_cast<scene::Index>(scene.patterns.size() - 1);
  return material;
}

/// The colour at the point that a ray meets is that of an even or odd cell.
void check_color(Judgement& judgement, const char* set, const tracer::World& world, Vec3 target, Vec3 from,
                 bool odd) {
  tracer::Ray ray;
  ray.origin = from;
  ray.direction = normalize(target - from);
  tracer::Stats stats;
  tracer::Hit hit;
  const bool right =
      closest(world, ray, stats, hit) && surface_at(world, ray, hit).ambient == grey(odd ? 0.3 : 0.9);
  judgement.check(right, set, [&] { return told(ray.origin, ray.direction); });
}

/// Scaled, in most cases turned, and moved.
Affine placed(Random& random) {
  const double scale = random.over_scales(1e-3, 1e3);
  const double away = random.below(2) == 0 ? 0 : 9;
  const Affine map = random.below(4) == 0 ? Affine{} : turned(random, away);
  return then(then(scaling({scale, scale, scale}), map), translation(random.in_cube(1)));
}

/// A box whose sides all lie in boundaries of cells.
void checkered_box(Judgement& judgement, Random& random) {
  constexpr int k_cells = 3;
  const double size = random.below(2) == 0 ? 1 : random.between(0.05, 2);
  const Affine map = random.below(4) == 0 ? Affine{} : placed(random);
  scene::Scene scene;
  const scene::Material material = patterned(scene, scene::Pattern::Kind::checker, size, {});
  int first[3];
  Vec3 lo, hi;
  for (int i = 0; i < 3; ++i) {
    first[i] = random.below(9) - 5;
    lo[i] = first[i] * size;
    hi[i] = (first[i] + k_cells) * size;
  }
  tracer::test::add_box(scene, lo, hi, material, map);
  const tracer::World world = tracer::prepare(scene);
  for (int ray = 0; ray < 32; ++ray) {
    const int face = random.below(6), axis = face / 2;
    Vec3 target;
    int sum = 0;
    for (int i = 0; i < 3; ++i) {
      const int cell = first[i] + (i != axis ? random.below(k_cells) : face % 2 == 0 ? 0 : k_cells);
      target[i] = (cell + (i == axis ? 0 : random.between(0.05, 0.95))) * size;
      sum += cell;
    }
    Vec3 from = target + random.in_cube(2) * size;
    from[axis] = target[axis] + (face % 2 == 0 ? -1 : 1) * random.between(0.5, 3) * size;
    check_color(judgement, "box", world, map.point(target), map.point(from), sum % 2 != 0);
  }
}

/// A plane in a boundary: of cells, or of stripes along its own normal.
void patterned_plane(Judgement& judgement, Random& random, bool striped) {
  const double size = random.below(2) == 0 ? 1 : random.between(0.05, 2);
  const int level = random.below(13) - 6;
  const Vec3 normal = !striped               ? Vec3{0, 1, 0}
                      : random.below(2) == 0 ? Vec3{0.28, 0.96, 0}
                                             : random.direction();
  const Affine map = random.below(3) == 0 ? Affine{} : placed(random);
  scene::Scene scene;
  using Kind = scene::Pattern::Kind;
  const scene::Material material = patterned(scene, striped ? Kind::stripes : Kind::checker, size, normal);
  tracer::test::add_shape(scene, scene::ShapeKind::plane, scene.planes, {{}, normal, level * size}, material,
                          map);
  const tracer::World world = tracer::prepare(scene);
  for (int ray = 0; ray < 32; ++ray) {
    const int column = random.below(21) - 10, row = random.below(21) - 10;
    const double x = (column + random.between(0.05, 0.95)) * size;
    const double z = (row + random.between(0.05, 0.95)) * size;
    Vec3 target = Vec3{x, 0, z};
    if (striped) target = target - normal * dot(target, normal);
    target = target + normal * (level * size);
    const double side = random.sign(), height = side * random.between(0.1, 5) * size;
    const Vec3 from = target + random.across(normal) * size + normal * height;
    const int sum = striped ? level : column + level + row;
    check_color(judgement, striped ? "stripes along the normal" : "plane", world, map.point(target),
                map.point(from), sum % 2 != 0);
  }
}

Outcome patterns(const Settings& settings) {
  const std::uint64_t worlds = settings.full ? 30000 : 600;
  Judgement judgement;
  for (std::uint64_t i = 0; i < worlds; ++i) {
    Random random(settings.seed, "picture.patterns", i);
    if (i % 2 == 0) checkered_box(judgement, random);
    if (i % 2 == 1) patterned_plane(judgement, random, i % 4 == 1);
  }
  return judgement.outcome();
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_exact_rows(Rows& rows) {
  using namespace flat;
  rows.push_back({"plane.exact", "slopes and heights of some 2^-130 of their terms, and of 0", plane_exact});
  rows.push_back(
      {"box.exits", "in by a side, out by an edge or a corner or next to it, aligned and turned", exits});
  rows.push_back({"mesh.edges",
                  "hits exactly on edges and diagonals of a cube, and all that goes on from there", edges});
  rows.push_back(
      {"media.sides", "points on surfaces and next to them: in, on or out, and eyes there", sides});
  rows.push_back({"picture.patterns", "faces in the boundaries of a pattern's cells: one colour", patterns});
}
