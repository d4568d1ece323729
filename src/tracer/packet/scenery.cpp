#include "tracer/packet/scenery.hpp"

#include <algorithm>

#include "tracer/candidates.hpp"
#include "tracer/packet/kernels.hpp"
#include "tracer/pattern.hpp"

namespace lancer::tracer {

namespace {

Shade shade_of(const World& world, const Primitive& p, ShadowWork shadows) {
  const scene::Texture& transmission = world.material_of(p.shape).transmission;
  if (!world.scene->shapes[p.shape].shadow) return Shade::none;
  if (shadows != ShadowWork::filtered || is_black(*world.scene, transmission)) return Shade::black;
  return is_convex_solid(p.kind) && transmission.pattern == scene::k_none ? Shade::filtered : Shade::unclear;
}

}  // namespace

PacketWorld::PacketWorld(const World& world, const Plan& plan) : looks_(Looks::of(world, plan)) {
  scenery_.world = &world;
  if (!world.tree.nodes().empty()) {
    scenery_.nodes = world.tree.nodes().data();
    scenery_.frames = world.tree.frames().data();
    scenery_.items = world.tree.items().data();
  }
  scenery_.bounded = world.bounded.data();
  listed_ = world.unbounded;
  for (const std::uint32_t sphere : world.listed_spheres.numbers()) listed_.push_back(sphere);
  scenery_.listed = listed_.data();
  scenery_.listed_count = listed_.size();
  scenery_.primitives = world.primitives.data();
  scenery_.spheres = world.spheres.data();
  scenery_.planes = world.planes.data();
  scenery_.facets = world.facets.data();
  scenery_.boxes = world.boxes.data();
  scenery_.has_facets = !world.facets.empty();
  for (const Primitive& p : world.primitives) {
    shade_.push_back(shade_of(world, p, plan.shadows));
  }
  scenery_.shade = shade_.data();
}

FirstRoot first_root(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction) {
  const Roots found = roots(world, primitive, Probe(origin, direction));
  FirstRoot first;
  first.in_doubt = found.passes;
  first.crossed = found.count == 2;
  for (int i = 0; i < found.count && !first.met && !first.in_doubt; ++i) {
    const Root& root = found.root[i];
    if (!(root.t > 0)) continue;
    first = {!root.loose, root.loose, root.entering, first.crossed, root.t, root.error};
  }
  return first;
}

Root way_out(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction) {
  return exit(world, primitive, origin, direction);
}

void own_bounds(const World& world, std::uint32_t primitive, double* box) {
  const Aabb own = bounds(world, primitive);
  for (int axis = 0; axis < 3; ++axis) {
    box[axis] = own.lo[axis];
    box[3 + axis] = own.hi[axis];
  }
}

bool land_alone(const World& world, const Ray& ray, std::uint32_t primitive, bool exits, Hit& hit) {
  const Probe probe(ray);
  const Roots found = exits ? Roots{1, {exit(world, primitive, ray.origin, ray.direction), {}}}
                            : roots(world, primitive, probe);
  const Root* root = nullptr;
  for (int i = 0; i < found.count && !root; ++i) root = found.root[i].t > 0 ? &found.root[i] : nullptr;
  if (!root) return false;
  Candidates candidates;
  const Interval own = exits ? k_anywhere : own_interval(world, primitive, probe);
  if (!(own.enter <= own.leave)) return false;
  candidates.add(primitive, *root, own);
  if (candidates.empty()) return false;
  const Landing landing = land(world, primitive, ray.origin, ray.direction, *root);
  hit.primitive = primitive;
  hit.shape = world.primitives[primitive].shape;
  hit.root = within(landing.root, own);
  hit.point = landing.point;
  hit.normal = landing.normal;
  if (hit.root.t > candidates.limit()) return false;
  const double since = hit.root.t - std::max(candidates.begin()->earliest, 0.0);
  hit.root.error = std::min(hit.root.error, std::max(since, candidates.limit() - hit.root.t));
  hit.point_error = hit.root.error + 4 * k_u * max_abs(hit.point);
  return hit.root.t > hit.root.error + ray.origin_error;
}

}  // namespace lancer::tracer
