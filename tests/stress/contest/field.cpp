#include "stress/contest/field.hpp"

namespace lancer::stress::flat {

Field make_field(const Settings& settings, const std::string& row, const Set& set, std::size_t rays) {
  const std::string name = row + "/" + set.name;
  Field field;
  field.set = set.name;
  for (std::size_t ray = 0; ray < rays; ++ray) {
    if (ray % k_rays_a_subject == 0) {
      Random random(settings.seed, name + "/subject", ray);
      field.subjects.push_back(set.make(random));
      field.worlds.push_back(tracer::prepare(*field.subjects.back().scene));
    }
    Random random(settings.seed, name, ray);
    field.lines.push_back(field.subjects.back().ray(random));
  }
  return field;
}

}  // namespace lancer::stress::flat
