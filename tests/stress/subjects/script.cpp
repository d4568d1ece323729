#include "stress/subjects/script.hpp"

#include <fmt/format.h>

namespace lancer::stress {

std::string at(Vec3 p) { return fmt::format("<{}, {}, {}>", p.x, p.y, p.z); }

std::string view(Vec3 eye, Vec3 look, double fov, int size, const std::string& more) {
  return fmt::format("view {{ eye {} look {} fov {} size {}, {} {} }}\n", at(eye), at(look), fov, size, size,
                     more);
}

}  // namespace lancer::stress
