#include "tracer/light_cells.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tracer/extent.hpp"
#include "tracer/light.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {
namespace {

constexpr std::size_t k_most_cells = 1 << 15;  // kept at a time

/// The most that the lamp brings to a point of the box.
double most_light(const scene::Light& lamp, Vec3 lo, Vec3 hi) {
  Vec3 outside;
  for (int axis = 0; axis < 3; ++axis)
    outside[axis] = std::max({lo[axis] - lamp.at[axis], 0.0, lamp.at[axis] - hi[axis]});
  const double ratio = lamp.falloff / length(outside);
  return max_component(lamp.color) * ratio * ratio;
}

}  // namespace

std::size_t LightCells::Hash::operator()(const Key& key) const {
  const std::hash<double> hash;
  std::size_t sum = 0;
  for (const double part : {key.x, key.y, key.z, key.size}) sum = (sum ^ hash(part)) * 0x9E3779B97F4A7C15U;
  return sum ^ (sum >> 29);
}

LightCells::Key LightCells::key_of(Vec3 p) const {
  const LightCellPlan& cells = plan_->light_cells;
  const Vec3 from_middle = p - cells.middle;
  const double away = max_abs(from_middle) / cells.reach;
  const double size = away > 1 ? std::scalbn(cells.size, std::ilogb(away) + 1) : cells.size;
  return {std::floor(from_middle.x / size), std::floor(from_middle.y / size),
          std::floor(from_middle.z / size), size};
}

LightCells::Cell LightCells::made(const Key& key) const {
  struct Lamp {
    double most;
    scene::Index light;
  };
  const LightCellPlan& cells = plan_->light_cells;
  const Vec3 corner = cells.middle + Vec3{key.x, key.y, key.z} * key.size;
  // As much larger as rounding may have a point beside its cell.
  const double margin = 1e-9 * (key.size + max_abs(corner) + max_abs(cells.middle));
  const Vec3 lo = corner - Vec3{margin, margin, margin};
  const double edge = key.size + 2 * margin;
  const Vec3 hi = lo + Vec3{edge, edge, edge};
  const double radius = edge * 0.8660254037844387 * (1 + 1e-9);  // half the root of 3
  Cell out;
  std::vector<Lamp> fading;
  const std::size_t count = plan_->every_light ? scene_->lights.size() : plan_->lights.size();
  for (std::size_t i = 0; i < count; ++i) {
    const scene::Index index = plan_->every_light ? static_cast<scene::Index>(i) : plan_->lights[i];
    const scene::Light& light = scene_->lights[index];
    if (cells.spots && light.kind == scene::LightKind::spot &&
        !may_light_ball(light, lo * 0.5 + hi * 0.5, radius)) {
      ++out.outside_cone;
    } else if (cells.faint > 0 && fades(light)) {
      fading.push_back({most_light(light, lo, hi), index});
    } else {
      out.lights.push_back(index);
    }
  }
  std::stable_sort(fading.begin(), fading.end(),
                   [](const Lamp& a, const Lamp& b) { return a.most < b.most; });
  double sum = 0;
  for (const Lamp& lamp : fading) {
    sum += lamp.most;
    if (sum <= cells.faint) {
      ++out.faint;
    } else {
      out.lights.push_back(lamp.light);
    }
  }
  std::sort(out.lights.begin(), out.lights.end());
  return out;
}

const LightCells::Cell& LightCells::at(Vec3 p) {
  const Key key = key_of(p);
  if (last_cell_ && key == last_) return *last_cell_;
  if (cells_.size() >= k_most_cells) cells_.clear();
  auto found = cells_.find(key);
  if (found == cells_.end()) found = cells_.emplace(key, made(key)).first;
  last_ = key;
  last_cell_ = &found->second;
  return *last_cell_;
}

}  // namespace lancer::tracer
