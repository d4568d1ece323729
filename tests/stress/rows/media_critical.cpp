// Rays at angles about the critical one: what comes back and what goes on.

#include <algorithm>
#include <cmath>

#include "stress/random.hpp"
#include "stress/rows/rows.hpp"
#include "stress/truth/reference/pictures.hpp"
#include "tracer/shade.hpp"

namespace lancer::stress {
namespace {

/// A ray in glass that arrives at its boundary, a plane.
struct Arrival {
  Vec3 normal, direction;
  double from = 1, to = 1;
};

struct Critical {
  std::uint64_t rays = 0, wrong = 0, in_band = 0;
  double reflectance = 0, direction = 0;  // the largest errors beyond what 4 ulp of the angle account for
};

reference::Vector nudged(const reference::Vector& d, const reference::Vector& n,
                         const reference::Real& part) {
  // Only the angle: longer or shorter along the surface.
  const reference::Vector up = n * dot(d, n);
  const reference::Vector along = d - up;
  const reference::Real sine = length(along) * (1 + part);
  if (sine >= 1) return d;
  return unit(along) * sine + unit(up) * sqrt(1 - sine * sine);
}

/// How much more a value is off than the truth itself changes within the band, of which p and q are the ends.
double beyond(const reference::Real& value, const reference::Real& wanted, const reference::Real& p,
              const reference::Real& q) {
  const reference::Real spread = std::max(reference::Real(abs(p - wanted)), reference::Real(abs(q - wanted)));
  return reference::Real(abs(value - wanted) - spread).convert_to<double>();
}

scene::Scene glass_below(const Arrival& a) {
  scene::Scene scene;
  scene.settings.ior = a.to;
  scene::Material glass;
  glass.ambient.color = glass.diffuse.color = {};
  glass.transmission.color = grey(1);
  glass.ior = a.from;
  glass.fresnel = true;
  scene.materials.push_back(glass);
  scene.planes.push_back({{}, a.normal, 0});
  scene::Shape shape;
  shape.kind = scene::ShapeKind::plane;
  scene.shapes.push_back(shape);
  return scene;
}

void arrive(const Arrival& a, Critical& out) {
  const scene::Scene scene = glass_below(a);
  const tracer::World world = tracer::prepare(scene);
  const tracer::Plan plan;
  tracer::Stats stats;
  tracer::Ray ray{-a.direction, a.direction, 0, {}, {}};
  ray.open.push_back(0);
  tracer::Hit hit;
  ++out.rays;
  if (!tracer::closest(world, ray, stats, hit)) {
    ++out.wrong;
    return;
  }
  const tracer::Shaded mine = tracer::shade({&world, &plan, nullptr}, ray, hit, true, stats);
  const reference::Vector n = -unit(reference::exact(a.normal)), d = unit(reference::exact(a.direction));
  const reference::Optics truth = optics(d, n, a.from, a.to);
  const reference::Real part = reference::Real(4) * 0x1p-52;
  const reference::Optics more = optics(nudged(d, n, part), n, a.from, a.to),
                          less = optics(nudged(d, n, -part), n, a.from, a.to);
  const bool band = more.total != less.total;
  if (!mine.transmitted != truth.total) {
    ++out.wrong;
    out.in_band += band ? 1 : 0;
    return;
  }
  if (!mine.reflected) {
    ++out.wrong;
    return;
  }
  // Under total reflection all of T comes from the mirror direction too.
  const double share = mine.reflected->share.r;
  out.reflectance =
      std::max(out.reflectance, beyond(share, truth.reflectance, more.reflectance, less.reflectance));
  const auto compare = [&](Vec3 got, const reference::Vector& wanted, const reference::Vector& p,
                           const reference::Vector& q) {
    for (int axis = 0; axis < 3; ++axis)
      out.direction = std::max(out.direction, beyond(got[axis], wanted[axis], p[axis], q[axis]));
  };
  compare(mine.reflected->ray.direction, truth.mirrored, more.mirrored, less.mirrored);
  if (mine.transmitted && !band)
    compare(mine.transmitted->ray.direction, truth.refracted, more.refracted, less.refracted);
}

Outcome critical(const Settings& settings) {
  const std::pair<double, double> indices[] = {{1.5, 1},      {1.33, 1},   {2.4, 1.5},
                                               {1.5, 1.4999}, {1.0003, 1}, {2, 1}};
  Critical all;
  for (const auto& [from, to] : indices) {
    for (int k = 3; k <= 17; ++k) {
      for (int i = 0; i < (settings.full ? 2000 : 60); ++i) {
        Random random(settings.seed, "media.critical", static_cast<std::uint64_t>(k * 100000 + i));
        Arrival a;
        a.from = from;
        a.to = to;
        a.normal = i % 3 == 0 ? Vec3{0, 0, 1} : random.direction();
        const double off = k == 17 ? 0 : (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -k) * random.between(0.5, 2);
        const reference::Vector n = unit(reference::exact(a.normal));
        const reference::Vector along = unit(cross(n, reference::exact(random.direction())));
        reference::Real sine = reference::Real(to) / from * (1 + reference::Real(off));
        if (sine > 1) sine = 1 - reference::Real("1e-9");
        const reference::Vector d = along * sine + n * sqrt(1 - sine * sine);
        a.direction =
            normalize({d.x.convert_to<double>(), d.y.convert_to<double>(), d.z.convert_to<double>()});
        arrive(a, all);
      }
    }
  }
  Outcome out;
  out.measures.push_back(measure_in_use("reflect or refract", all.rays, all.wrong, all.in_band));
  out.limits = {{"wrong about total reflection", static_cast<double>(all.wrong - all.in_band), 0},
                {"reflectance beyond the band", all.reflectance, 1e-15},
                {"direction beyond the band", all.direction, 4e-16}};
  return out;
}

}  // namespace

void add_media_critical_rows(Rows& rows) {
  rows.push_back({"media.critical", "total reflection within 1e-3 to 1e-16 of the critical angle", critical});
}

}  // namespace lancer::stress
