#pragma once
// The radiance along a ray by the formulas of the language, term by term and without any search structure:
// what a picture is judged by. It shares no code with the tracer that it judges.

#include <cstdint>
#include <vector>

#include "body.hpp"

namespace lancer::reference {

struct Radiance {
  Real r = 0, g = 0, b = 0;
};

/// What may be one thing written with different rounding: surfaces count as coincident, and points as lying
/// in a cell's boundary, where no more than this part of their coordinates is between them.
struct Tolerance {
  double coincident = 1e-14;
  double boundary = 2e-15;
};

/// A surface that passes through the start of a ray.
struct Contact {
  std::size_t body = 0;
  std::uint32_t face = 0;
  bool inside = false;  // the ray starts on the side that the normal points away from
  bool left = false;    // the ray leaves this surface
  Vector normal;
};

struct Ray {
  Vector origin, direction;  // any length but zero
  std::vector<Contact> contacts;
  std::vector<std::size_t> open;  // solids, in the order of entry
};

/// A surface that a ray meets.
struct Meeting {
  std::size_t body = 0;
  Real t;
  bool entering = true;
  std::uint32_t face = 0;
  Vector point, normal;           // flat, outward
  std::vector<Contact> contacts;  // all surfaces that pass through the point, this one too
};

/// What becomes of light between two media.
struct Optics {
  bool total = false;    // total reflection
  Real reflectance = 0;  // of unpolarised light; 1 under total reflection, 0 between equal indices
  Vector mirrored, refracted;
};
/// d of unit length, n facing it: n . d < 0.
Optics optics(const Vector& d, const Vector& n, const Real& from, const Real& to);

class Tracer {
 public:
  explicit Tracer(const scene::Scene& scene, Tolerance tolerance = {});

  /// A ray of the view, with the solids around its start open.
  Ray from_eye(const Vector& origin, const Vector& direction) const;
  Radiance radiance(const Ray& ray, int depth);
  bool closest(const Ray& ray, Meeting& out) const;
  /// The ray that goes on from a meeting; `open` as given.
  Ray onwards(const Meeting& met, const Vector& direction, const std::vector<std::size_t>& open) const;
  /// The open solids after the surface was crossed.
  std::vector<std::size_t> crossed(const Ray& ray, const Meeting& met) const;
  Real index(const std::vector<std::size_t>& open) const;

  const Body& body(std::size_t i) const { return bodies_[i]; }
  std::size_t body_count() const { return bodies_.size(); }

  /// A number that stands for everything that was met, which side of what was taken and so on, since the last
  /// reset: two rays with the same one had the same course.
  std::uint64_t course() const { return course_; }
  void reset_course() { course_ = 0xCBF29CE484222325U; }

 private:
  struct Crossing {
    std::size_t body = 0;
    Root root;
    bool at_start = false;
  };
  /// What a surface shows where it is met.
  struct Look {
    Vector normal;  // smooth where the shape is, turned to face the ray
    Radiance ambient, diffuse, specular, reflection, transmission;
  };

  void note(std::uint64_t what) { course_ = (course_ ^ what) * 0x100000001B3U; }
  const scene::Material& material(std::size_t body) const;
  /// Everything that the ray crosses after its start, and what it meets right there, in no order.
  void crossings(const Ray& ray, std::vector<Crossing>& out) const;
  bool met_at_start(const Ray& ray, Meeting& out) const;
  Radiance color(const scene::Texture& texture, const Body& body, const Vector& p);
  Look look(const Ray& ray, const Meeting& met);
  Radiance from_light(const scene::Light& light, const Ray& ray, const Meeting& met, const Look& look);
  /// `reach`: how many lengths of the direction away the light is; none: infinitely many.
  Radiance light_through(const Ray& ray, const Real* reach);
  /// Adds kr R and kt T.
  void follow(const Ray& ray, const Meeting& met, const Look& look, int depth, Radiance& sum);
  void add(Radiance& sum, const Radiance& term) const;

  const scene::Scene& scene_;
  Tolerance tolerance_;
  std::vector<Body> bodies_;
  std::uint64_t course_ = 0;
};

}  // namespace lancer::reference
