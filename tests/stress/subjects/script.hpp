#pragma once
// Parts that scripts for pictures are put together from.

#include <string>

#include "base/vec.hpp"

namespace lancer::stress {

/// The vector as it is written in a script.
std::string at(Vec3 p);

/// A square picture; `more`: further attributes.
std::string view(Vec3 eye, Vec3 look, double fov, int size, const std::string& more = "");

/// Turned so that nothing lies along an axis any more.
inline constexpr const char* k_oblique = "rotate <31, 17, 53> scale 0.7 translate <0.1, 0.3, -0.2>";

}  // namespace lancer::stress
