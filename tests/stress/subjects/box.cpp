#include "stress/subjects/box.hpp"

#include <cmath>
#include <utility>

#include "stress/subjects/placement.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

Vec3 any_size(Random& random, double least, double most) {
  const double x = random.over_scales(least, most), y = random.over_scales(least, most),
               z = random.over_scales(least, most);
  return {x, y, z};
}

/// From `distance` before the target, in the direction q of the box's own coordinates.
Line through(const PlacedBox& box, Vec3 target, Vec3 q, double distance) {
  const Vec3 d = normalize(box.vector(q));
  return {box.point(target) - d * distance, d};
}

}  // namespace

Vec3 PlacedBox::point(Vec3 q) const {
  Vec3 own;
  for (int axis = 0; axis < 3; ++axis) {
    const double share = (q[axis] + 1) * 0.5;
    own[axis] = q[axis] == 1 ? hi[axis] : lo[axis] + (hi[axis] - lo[axis]) * share;
  }
  return flat::placed(map, own);
}

Vec3 PlacedBox::vector(Vec3 q) const {
  const Vec3 h = (hi - lo) * 0.5;
  return map.vector({h.x * q.x, h.y * q.y, h.z * q.z});
}

double PlacedBox::largest() const {
  return std::fmax(length(vector({1, 0, 0})),
                   std::fmax(length(vector({0, 1, 0})), length(vector({0, 0, 1}))));
}

double PlacedBox::smallest() const {
  return std::fmin(length(vector({1, 0, 0})),
                   std::fmin(length(vector({0, 1, 0})), length(vector({0, 0, 1}))));
}

double PlacedBox::distance(Random& random) const {
  const double size = random.below(2) == 0 ? largest() : smallest();
  return size * random.between(2, 10);
}

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

PlacedBox any_box(Style style, Random& random, double scale, double away) {
  PlacedBox box;
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

Line past(const PlacedBox& box, Random& random) {
  const double distance = box.distance(random);
  return towards(box.point(random.in_cube(1.2)), distance, random);
}

Line at_rim(const PlacedBox& box, Where where, double offset, Random& random) {
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

Line common_ray(const PlacedBox& box, Random& random) {
  const int what = random.below(5);
  if (what == 0) return past(box, random);
  if (what == 1) return {box.point(random.in_cube(0.95)), random.direction()};
  const Where where = what == 2 ? Where::silhouette : what == 3 ? Where::front_edge : Where::corner;
  return at_rim(box, where, ten_to_minus(random.below(17)), random);
}

Subject subject(const PlacedBox& box, std::function<Line(Random&)> ray) {
  Subject out;
  tracer::test::add_box(*out.scene, box.lo, box.hi, {}, box.map);
  out.ray = std::move(ray);
  return out;
}

}  // namespace lancer::stress::flat
