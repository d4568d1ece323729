// What surfaces look like: patterns, lights, shadows, mirrors and refraction, by the formulas of the
// language.

#include <algorithm>
#include <tuple>

#include "tracer.hpp"

namespace lancer::reference {
namespace {

Radiance rgb(const Color& c) { return {c.r, c.g, c.b}; }
Radiance operator+(const Radiance& a, const Radiance& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
Radiance operator*(const Radiance& a, const Radiance& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
Radiance operator*(const Radiance& a, const Real& s) { return {a.r * s, a.g * s, a.b * s}; }
bool is_black(const Radiance& c) { return c.r == 0 && c.g == 0 && c.b == 0; }

/// May the colour be other than black somewhere?
bool may_show(const scene::Scene& scene, const scene::Texture& texture) {
  if (texture.pattern == scene::k_none) return !lancer::is_black(texture.color);
  const scene::Pattern& p = scene.patterns[texture.pattern];
  return !lancer::is_black(p.a) || !lancer::is_black(p.b);
}

/// Is the cell odd that the coordinate lies in? Within `reach` of the next boundary it lies in the next cell.
bool odd_cell(const Real& coordinate, const Real& reach, const Real& size) {
  const Real half = floor((coordinate + reach) / size) / 2;
  return half != floor(half);
}

/// 1 within the inner cone, 0 outside the outer, the smoothstep of the angle between.
Real cone(const scene::Light& light, const Vector& towards) {
  const Vector axis = unit(exact(light.direction));
  const Real angle = atan2(length(cross(axis, towards)), -dot(axis, towards)) * 180 / acos(Real(-1));
  const Real outer = Real(light.angle) / 2, inner = Real(light.angle) * (1 - Real(light.softness)) / 2;
  if (angle <= inner) return 1;
  if (angle >= outer) return 0;
  const Real x = (outer - angle) / (outer - inner);
  return x * x * (3 - 2 * x);
}

}  // namespace

Radiance Tracer::color(const scene::Texture& texture, const Body& body, const Vector& p) {
  if (texture.pattern == scene::k_none) return rgb(texture.color);
  const scene::Pattern& pattern = scene_.patterns[texture.pattern];
  const Vector own = body.own_point(p), reach = body.own_reach(p) * Real(tolerance_.boundary);
  bool odd = false;
  switch (pattern.kind) {
    case scene::Pattern::Kind::checker:
      for (int axis = 0; axis < 3; ++axis) odd ^= odd_cell(own[axis], reach[axis], pattern.size);
      break;
    case scene::Pattern::Kind::stripes: {
      const Vector axis = unit(exact(pattern.axis));
      odd = odd_cell(dot(own, axis), dot({abs(axis.x), abs(axis.y), abs(axis.z)}, reach), pattern.size);
      break;
    }
    case scene::Pattern::Kind::gradient: {
      const Vector way = exact(pattern.to) - exact(pattern.from);
      Real t = dot(own - exact(pattern.from), way) / dot(way, way);
      t = t < 0 ? Real(0) : t > 1 ? Real(1) : t;
      return rgb(pattern.a) * (1 - t) + rgb(pattern.b) * t;
    }
  }
  note(odd ? 3 : 2);
  return rgb(odd ? pattern.b : pattern.a);
}

Tracer::Look Tracer::look(const Ray& ray, const Meeting& met) {
  const Body& body = bodies_[met.body];
  const scene::Material& m = material(met.body);
  Look out;
  out.normal = body.smooth_normal(met.point, met.face);
  if (dot(out.normal, ray.direction) > 0) out.normal = -out.normal;
  out.ambient = color(m.ambient, body, met.point);
  out.diffuse = color(m.diffuse, body, met.point);
  out.specular = color(m.specular, body, met.point);
  out.reflection = color(m.reflection, body, met.point);
  out.transmission = color(m.transmission, body, met.point);
  return out;
}

Radiance Tracer::light_through(const Ray& ray, const Real* reach) {
  if (scene_.settings.shadows == scene::Shadows::off) return {1, 1, 1};
  std::vector<Crossing> found;
  crossings(ray, found);
  std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.body, a.root.entering, a.root.t) < std::tie(b.body, b.root.entering, b.root.t);
  });
  Radiance through{1, 1, 1};
  const Crossing* before = nullptr;
  for (const Crossing& c : found) {
    if (reach && c.root.t >= *reach) continue;
    const Body& body = bodies_[c.body];
    if (!scene_.shapes[body.shape()].shadow) continue;
    note(0x100 + 2 * c.body + (c.root.entering ? 1 : 0));
    if (scene_.settings.shadows == scene::Shadows::opaque) return {};
    const Vector p = ray.origin + ray.direction * c.root.t;
    // Where facets of one mesh meet, it is crossed once.
    if (before && before->body == c.body && before->root.entering == c.root.entering &&
        (c.root.t - before->root.t) * length(ray.direction) <= Real(tolerance_.coincident) * largest(p)) {
      continue;
    }
    through = through * color(material(c.body).transmission, body, p);
    before = &c;
  }
  return through;
}

Radiance Tracer::from_light(const scene::Light& light, const Ray& ray, const Meeting& met, const Look& look) {
  const bool sun = light.kind == scene::LightKind::sun;
  const Vector way = sun ? -exact(light.direction) : exact(light.at) + exact(light.at_rest) - met.point;
  const Real distance = length(way);
  if (distance == 0) return {};
  const Vector towards = way / distance;
  Radiance intensity = rgb(light.color);
  if (!sun && light.falloff > 0)
    intensity = intensity * ((light.falloff / distance) * (light.falloff / distance));
  if (light.kind == scene::LightKind::spot) intensity = intensity * cone(light, towards);
  const Real facing = dot(look.normal, towards);
  if (facing <= 0 || is_black(intensity)) return {};
  Radiance bracket = look.diffuse * facing;
  if (!is_black(look.specular)) {
    const Real glance = dot(look.normal, unit(towards - unit(ray.direction)));
    if (glance > 0) bracket = bracket + look.specular * pow(glance, Real(material(met.body).shininess));
  }
  if (is_black(bracket)) return {};
  const Ray shadow = onwards(met, way, {});
  const Real one = 1;
  return light_through(shadow, sun ? nullptr : &one) * intensity * bracket;
}

void Tracer::add(Radiance& sum, const Radiance& term) const {
  if (scene_.settings.sum == scene::Sum::linear) {
    sum = sum + term;
    return;
  }
  const auto join = [](Real& a, const Real& b) {
    const Real part = b < 0 ? Real(0) : b > 1 ? Real(1) : b;
    a = 1 - (1 - a) * (1 - part);
  };
  join(sum.r, term.r);
  join(sum.g, term.g);
  join(sum.b, term.b);
}

Radiance Tracer::radiance(const Ray& ray, int depth) {
  Meeting met;
  if (!closest(ray, met)) {
    note(1);
    return rgb(scene_.settings.background);
  }
  note(0x10000 + 16 * met.body + 8 * (met.entering ? 1U : 0U) + met.face);
  const Look look = this->look(ray, met);
  Radiance sum;
  add(sum, look.ambient * rgb(scene_.settings.ambient));
  for (const scene::Light& light : scene_.lights) add(sum, from_light(light, ray, met, look));
  if (depth > 0 && (may_show(scene_, material(met.body).reflection) ||
                    may_show(scene_, material(met.body).transmission))) {
    follow(ray, met, look, depth, sum);
  }
  return sum;
}

Optics optics(const Vector& d, const Vector& n, const Real& from, const Real& to) {
  const Real cosine = -dot(d, n);
  const Real ratio = from / to;
  const Real square = 1 - ratio * ratio * (1 - cosine * cosine);
  Optics out;
  out.mirrored = d + n * (2 * cosine);
  out.total = square < 0;
  if (from == to) {
    out.refracted = d;
    return out;
  }
  out.reflectance = 1;
  if (out.total) return out;
  const Real beyond = sqrt(square);
  out.refracted = d * ratio + n * (ratio * cosine - beyond);
  const Real across = (from * cosine - to * beyond) / (from * cosine + to * beyond);
  const Real within = (to * cosine - from * beyond) / (to * cosine + from * beyond);
  out.reflectance = (across * across + within * within) / 2;
  return out;
}

void Tracer::follow(const Ray& ray, const Meeting& met, const Look& look, int depth, Radiance& sum) {
  const std::vector<std::size_t> beyond = crossed(ray, met);
  const Optics to = optics(unit(ray.direction), look.normal, index(ray.open), index(beyond));
  const auto mirror = [&] { return radiance(onwards(met, to.mirrored, ray.open), depth - 1); };
  Radiance kr = look.reflection, kt = look.transmission;
  if (is_black(kt)) {
    if (!is_black(kr)) add(sum, kr * mirror());
    return;
  }
  note(to.total ? 5 : 4);
  if (material(met.body).fresnel) {
    kr = kr + kt * to.reflectance;
    kt = kt * (1 - to.reflectance);
  }
  if (to.total) {
    // T is the mirror radiance: one ray for both.
    if (is_black(kr) && is_black(kt)) return;
    const Radiance mirrored = mirror();
    add(sum, kr * mirrored);
    add(sum, kt * mirrored);
    return;
  }
  if (!is_black(kr)) add(sum, kr * mirror());
  if (!is_black(kt)) add(sum, kt * radiance(onwards(met, to.refracted, beyond), depth - 1));
}

}  // namespace lancer::reference
