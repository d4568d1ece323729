#pragma once
// Ways to go on from a surface: the tracer's own, and the rules of thumb that others keep rays off the
// surface with which they leave it. Each finds what a ray meets that starts where another one ended.

#include <string>

#include "stress/contest/line.hpp"
#include "tracer/intersect.hpp"
#include "tracer/media.hpp"

namespace lancer::stress::flat {

/// What the tracer does.
class OwnWalk {
 public:
  struct Place {
    tracer::Hit hit;
    tracer::OpenSolids open;  // of the ray that came
    Vec3 point() const { return hit.point; }
    Vec3 normal() const { return hit.normal; }
    double t() const { return hit.root.t; }
    std::uint32_t primitive() const { return hit.primitive; }
    std::uint32_t shape() const { return hit.shape; }
    bool entering() const { return hit.root.entering; }
  };

  /// From outside of everything.
  bool start(const tracer::World& world, const Line& line, Place& to) const;
  bool go(const tracer::World& world, const Place& from, Vec3 direction, Place& to) const;
  /// Where that ray starts.
  Vec3 from(const Place& place, Vec3) const { return place.hit.point; }
};

/// How rays are kept off the surface that they leave.
struct Rule {
  std::string name;
  double least = 0;     // nothing nearer is met
  double offset = 0;    // the start is moved by this along the normal
  bool in_ulp = false;  // the start is moved by Waechter and Binder's way (Ray Tracing Gems, chapter 6)
};

/// A plain tracer that keeps to a rule: plain arithmetic on every primitive in turn.
class RuleWalk {
 public:
  struct Place {
    Vec3 at, outward;
    double distance = 0;
    std::uint32_t of_primitive = 0, of_shape = 0;
    bool enters = false;
    Vec3 point() const { return at; }
    Vec3 normal() const { return outward; }
    double t() const { return distance; }
    std::uint32_t primitive() const { return of_primitive; }
    std::uint32_t shape() const { return of_shape; }
    bool entering() const { return enters; }
  };

  explicit RuleWalk(Rule rule) : rule_(std::move(rule)) {}
  bool start(const tracer::World& world, const Line& line, Place& to) const;
  bool go(const tracer::World& world, const Place& from, Vec3 direction, Place& to) const;
  Vec3 from(const Place& place, Vec3 direction) const;

 private:
  Rule rule_;
};

}  // namespace lancer::stress::flat
