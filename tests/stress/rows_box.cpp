// Boxes, along the axes and turned: one box a world, rays at its silhouettes, front edges and corners, in the
// planes of its sides, from inside and from afar.

#include <fmt/format.h>

#include "stress/contest.hpp"
#include "stress/methods_box.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

struct BoxKind {
  using Numbers = BoxNumbers;
  static BoxNumbers numbers(const tracer::World& world) {
    const tracer::BoxPrimitive& b = world.boxes.at(0);
    return {b.lo, b.hi, !b.aligned, b.center, b.to_own};
  }
  static const BoxNumbers& plain(const BoxNumbers& b) { return b; }
  static Truth truth(const BoxNumbers& b, Vec3 o, Vec3 d) { return box_truth(b, o, d); }
  static bool in_band(const BoxNumbers& b, Vec3 o, Vec3 d) { return box_in_band(b, o, d); }
  static int face(const tracer::Root& root) { return root.face; }
  static std::string tell(const BoxNumbers& b) {
    std::string text = fmt::format("box {} {}", exactly(b.lo), exactly(b.hi));
    if (!b.turned) return text;
    return text + fmt::format(" center {} to_own {} {} {}", exactly(b.center), exactly(b.to_own[0]),
                              exactly(b.to_own[1]), exactly(b.to_own[2]));
  }
};

using BoxContest = Contest<BoxKind, TwelveFacets, SlabReciprocal, SlabDivision, DoubleDoubleBox>;

constexpr int k_powers[] = {3, 6, 8, 10, 12, 14, 15, 16};
double ten_to_minus(int k) { return 1 / std::pow(10.0, k); }

/// A box as it is put into a scene, in coordinates q that are -1 to 1 across it.
struct Placed {
  Vec3 lo, hi;
  Affine map;

  Vec3 half() const { return (hi - lo) * 0.5; }
  Vec3 point(Vec3 q) const {
    Vec3 own;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = (q[axis] + 1) * 0.5;
      own[axis] = q[axis] == 1 ? hi[axis] : lo[axis] + (hi[axis] - lo[axis]) * share;
    }
    return is_identity(map) ? own : map.point(own);
  }
  Vec3 vector(Vec3 q) const {
    const Vec3 h = half();
    return map.vector({h.x * q.x, h.y * q.y, h.z * q.z});
  }
  double largest() const {
    return std::fmax(length(vector({1, 0, 0})),
                     std::fmax(length(vector({0, 1, 0})), length(vector({0, 0, 1}))));
  }
  double smallest() const {
    return std::fmin(length(vector({1, 0, 0})),
                     std::fmin(length(vector({0, 1, 0})), length(vector({0, 0, 1}))));
  }
  /// A distance that is ordinary for it: 2 to 10 of its largest or of its smallest size.
  double distance(Random& random) const {
    const double size = random.below(2) == 0 ? largest() : smallest();
    return size * random.between(2, 10);
  }
};

enum class Style { aligned, aligned_uneven, turned, uneven, nested };
constexpr Style k_styles[] = {Style::aligned, Style::aligned_uneven, Style::turned, Style::uneven,
                              Style::nested};

const char* name_of(Style style) {
  switch (style) {
    case Style::aligned: return "aligned";
    case Style::aligned_uneven: return "aligned, 1 : 1e+-4";
    case Style::turned: return "turned";
    case Style::uneven: return "turned, 1 : 1e+-4";
    case Style::nested: return "groups in groups";
  }
  return "";
}

Vec3 any_size(Random& random, double least, double most) {
  const double x = random.over_scales(least, most), y = random.over_scales(least, most),
               z = random.over_scales(least, most);
  return {x, y, z};
}

/// About one unit across, unless uneven; then moved by `away` in a random direction, then scaled.
Placed make(Style style, Random& random, double scale = 1, double away = 0) {
  Placed box;
  const bool uneven = style == Style::uneven || style == Style::aligned_uneven;
  const Vec3 half = uneven ? any_size(random, 1e-4, 1e4) : any_size(random, 0.3, 1);
  const Vec3 direction = random.direction();
  const Vec3 offset = random.in_cube(0.5) + direction * away;
  if (style == Style::aligned || style == Style::aligned_uneven) {
    box.lo = (offset - half) * scale;
    box.hi = (offset + half) * scale;
    return box;
  }
  box.lo = -half;
  box.hi = half;
  const auto turn = [&] {
    const double angle = random.between(-180, 180);
    return rotation(random.direction(), angle);
  };
  box.map = turn();
  if (style == Style::nested) {
    for (int level = 0; level < 3; ++level) {
      box.map = then(box.map, scaling(any_size(random, 0.5, 2)));
      box.map = then(box.map, translation(random.in_cube(0.5)));
      box.map = then(box.map, turn());
    }
  }
  box.map = then(box.map, translation(offset));
  if (scale != 1) box.map = then(box.map, scaling({scale, scale, scale}));
  return box;
}

Subject subject(const Placed& box, std::function<Line(Random&)> ray) {
  Subject out;
  tracer::test::add_box(*out.scene, box.lo, box.hi, {}, box.map);
  out.ray = std::move(ray);
  return out;
}

Line towards(Vec3 target, double distance, Random& random) {
  const Vec3 origin = target + random.direction() * distance;
  return {origin, normalize(target - origin)};
}

/// At it or past it, from an ordinary distance.
Line past(const Placed& box, Random& random) {
  const double distance = box.distance(random);
  return towards(box.point(random.in_cube(1.2)), distance, random);
}

/// From `distance` before the target, in the direction q of the box's own coordinates.
Line through(const Placed& box, Vec3 target, Vec3 q, double distance) {
  const Vec3 d = normalize(box.vector(q));
  return {box.point(target) - d * distance, d};
}

enum class Where { silhouette, front_edge, corner };

/// Past or onto an edge or a corner, off it by `offset` of the box.
Line at_rim(const Placed& box, Where where, double offset, Random& random) {
  const int i = random.below(3), j = (i + 1 + random.below(2)) % 3, k = 3 - i - j;
  Vec3 q, d;
  q[i] = random.sign();
  q[j] = random.sign();
  q[k] = where == Where::corner ? random.sign() : random.between(-0.9, 0.9);
  d[i] = -q[i] * random.between(0.2, 1);
  d[j] = (where == Where::silhouette ? 1 : -1) * q[j] * random.between(0.2, 1);
  d[k] = random.between(-1, 1);
  const double across = random.sign() * offset;
  if (where == Where::front_edge) {
    q[i] -= q[i] * across;
  } else {
    q[i] += q[i] * across;
    q[j] += q[j] * offset * random.between(-1, 1);
  }
  if (where == Where::corner) q[k] += offset * random.between(-1, 1);
  return through(box, q, d, box.distance(random));
}

/// A mixture that every placement of a box is tried with.
Line common_ray(const Placed& box, Random& random) {
  const int what = random.below(5);
  if (what == 0) return past(box, random);
  if (what == 1) return {box.point(random.in_cube(0.95)), random.direction()};
  const Where where = what == 2 ? Where::silhouette : what == 3 ? Where::front_edge : Where::corner;
  return at_rim(box, where, ten_to_minus(random.below(17)), random);
}

template <class Ray>
void add_styles(Sets& sets, const std::string& name, Ray ray) {
  for (const Style style : k_styles) {
    sets.push_back(
        {name.empty() ? name_of(style) : fmt::format("{}, {}", name, name_of(style)), [=](Random& random) {
           const Placed box = make(style, random);
           return subject(box, [=](Random& r) { return ray(box, r); });
         }});
  }
}

Sets uniform_sets() {
  Sets sets;
  add_styles(sets, "", [](const Placed& box, Random& r) { return past(box, r); });
  return sets;
}

Sets inside_sets() {
  Sets sets;
  add_styles(sets, "", [](const Placed& box, Random& r) {
    const Vec3 origin = box.point(r.in_cube(0.95));
    return Line{origin, r.below(2) == 0 ? r.direction() : normalize(box.vector(r.direction()))};
  });
  return sets;
}

Sets far_sets() {
  Sets sets;
  for (int k = 1; k <= 9; ++k) {
    add_styles(sets, fmt::format("1e{}", k), [k](const Placed& box, Random& r) {
      return towards(box.point(r.in_cube(1.2)), box.largest() * std::pow(10.0, k), r);
    });
  }
  return sets;
}

Sets rim_sets(Where where) {
  Sets sets;
  for (const int k : k_powers) {
    add_styles(sets, fmt::format("1e-{}", k),
               [=](const Placed& box, Random& r) { return at_rim(box, where, ten_to_minus(k), r); });
  }
  return sets;
}
Sets silhouette_sets() { return rim_sets(Where::silhouette); }
Sets edge_sets() { return rim_sets(Where::front_edge); }
Sets corner_sets() { return rim_sets(Where::corner); }

Sets near_sets() {
  Sets sets;
  for (const int k : {4, 6, 8, 10, 12}) {
    add_styles(sets, fmt::format("1e-{}", k), [k](const Placed& box, Random& r) {
      Vec3 q = r.in_cube(0.95);
      const int axis = r.below(3);
      q[axis] = r.sign() * (1 + ten_to_minus(k));
      return Line{box.point(q), r.direction()};
    });
  }
  return sets;
}

Set placed(const std::string& name, Style style, double scale, double away) {
  return {fmt::format("{}, {}", name, name_of(style)), [=](Random& random) {
            const Placed box = make(style, random, scale, away);
            return subject(box, [box](Random& r) { return common_ray(box, r); });
          }};
}

Sets scaled_sets() {
  Sets sets;
  for (const Style style : k_styles) {
    for (const int k : {-9, -6, -3, 3, 6, 9})
      sets.push_back(placed(fmt::format("1e{}", k), style, std::pow(10.0, k), 0));
    for (const int k : {-100, 100})
      sets.push_back(placed(fmt::format("2^{}", k), style, std::scalbn(1.0, k), 0));
  }
  return sets;
}

Sets moved_sets() {
  Sets sets;
  for (const Style style : k_styles) {
    for (int k = 3; k <= 9; ++k) sets.push_back(placed(fmt::format("1e{}", k), style, 1, std::pow(10.0, k)));
  }
  return sets;
}

/// Rays in the plane of a side, on and beside it.
Sets plane_sets() {
  Sets sets;
  sets.push_back({"aligned", [](Random& random) {
                    const Placed box = make(Style::aligned, random);
                    return subject(box, [box](Random& r) {
                      const int axis = r.below(3);
                      Vec3 q = r.in_cube(1.3), d = r.direction();
                      q[axis] = r.sign();
                      d[axis] = 0;
                      d = normalize(d);
                      d[axis] = r.below(2) == 0 ? 0.0 : -0.0;
                      Vec3 origin = box.point(q) - d * box.distance(r);
                      origin[axis] = q[axis] > 0 ? box.hi[axis] : box.lo[axis];
                      return Line{origin, d};
                    });
                  }});
  // Turned by 45 degrees in numbers that need no rounding: the side's plane is x - y = 2 half.
  sets.push_back({"turned", [](Random& random) {
                    Placed box;
                    const double half = std::scalbn(1.0, random.below(5) - 2);
                    box.hi = {half, 1, 1};
                    box.lo = -box.hi;
                    box.map.rows = {Vec3{1, 1, 0}, Vec3{-1, 1, 0}, Vec3{0, 0, 1}};
                    return subject(box, [half](Random& r) {
                      Vec3 d = r.direction();
                      d.x = d.y = std::nearbyint(d.x * 0x1p40) * 0x1p-40;
                      d = normalize(d);
                      d.y = d.x;
                      const double y = std::nearbyint(r.between(-8, 8) * 0x1p20) * 0x1p-20;
                      const double x = y + r.sign() * 2 * half;
                      return Line{{x, y, r.between(-1.2, 1.2)}, d};
                    });
                  }});
  return sets;
}

Sets axis_sets() {
  Sets sets;
  for (const double rest : {0.0, -0.0, 0x1p-1074, -0x1p-1074, 0x1p-1040, -1e-300}) {
    add_styles(sets, fmt::format("{:.2g}", rest), [rest](const Placed& box, Random& r) {
      const int axis = r.below(3);
      Vec3 d{rest, rest, rest};
      d[axis] = r.sign();
      Vec3 q = r.in_cube(1.2);
      for (const int share : {2, 4}) {
        const int on = r.below(3);
        const double side = r.sign();
        if (r.below(share) == 0) q[on] = side;
      }
      return Line{box.point(q) - d * box.distance(r), d};
    });
  }
  return sets;
}

/// Two or three sides met at exactly the same distance: the ray runs along a diagonal of the axes.
Sets exact_sets() {
  Sets sets;
  for (const bool corner : {false, true}) {
    sets.push_back({corner ? "a corner" : "an edge", [corner](Random& random) {
                      Placed box;
                      box.hi = {1.0 + random.below(4), 1.0 + random.below(4), 1.0 + random.below(4)};
                      box.lo = -box.hi;
                      return subject(box, [=](Random& r) {
                        const int single = r.below(3);
                        const double away = 1 + r.below(8);
                        Vec3 d, origin;
                        for (int axis = 0; axis < 3; ++axis) {
                          const double sign = r.sign();
                          d[axis] = sign;
                          origin[axis] = sign * (-away - box.hi[axis]);
                          if (corner || axis != single) continue;
                          d[axis] = r.between(-0.1, 0.1);
                          origin[axis] = r.between(-0.5, 0.5) - d[axis] * away;
                        }
                        const double size = length(d);
                        return Line{origin, d / size};
                      });
                    }});
  }
  return sets;
}

void add(Rows& rows, const std::string& name, const std::string& about, Sets (*sets)()) {
  rows.push_back({name, about,
                  [name, sets](const Settings& settings) { return BoxContest(settings, name).run(sets()); }});
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_box_rows(Rows& rows) {
  using namespace flat;
  add(rows, "box.uniform", "from 2 to 10 sizes, at and past it; along the axes, turned, uneven, in groups",
      uniform_sets);
  add(rows, "box.inside", "from inside", inside_sets);
  add(rows, "box.far", "from 1e1 to 1e9 sizes", far_sets);
  add(rows, "box.silhouettes", "within 1e-3 to 1e-16 of an edge that they graze", silhouette_sets);
  add(rows, "box.edges", "within 1e-3 to 1e-16 of an edge where they enter", edge_sets);
  add(rows, "box.corners", "within 1e-3 to 1e-16 of a corner", corner_sets);
  add(rows, "box.planes", "exactly in the plane of a side", plane_sets);
  add(rows, "box.axes", "along an axis, the other components 0, -0 and denormal", axis_sets);
  add(rows, "box.near", "from 1e-4 to 1e-12 sizes above a side", near_sets);
  add(rows, "box.scaled", "scaled by 1e-9 to 1e9 and 2^+-100", scaled_sets);
  add(rows, "box.moved", "moved by 1e3 to 1e9 sizes", moved_sets);
  add(rows, "box.exact", "edges and corners met at exactly the same distance", exact_sets);
}
