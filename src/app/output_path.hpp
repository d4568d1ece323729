#pragma once
// Where pictures go: beside the script unless told otherwise.

#include <optional>
#include <string>
#include <vector>

#include "image/format.hpp"

namespace lancer::app {

/// "-": standard input or output.
inline constexpr const char* k_stream = "-";

/// ".png", ".ppm", ...
std::string ending_of(image::Format format);

/// "dir/lamp.scn" -> "dir/lamp.png".
std::string beside_script(const std::string& script, image::Format format);

/// "lamp.png" and the views "top", "a/b" -> "lamp-top.png", "lamp-a-b.png": what does not belong in the name
/// of a file becomes `-`, and names that are the same are counted, "lamp-top-2.png".
std::vector<std::string> paths_of_views(const std::string& path, const std::vector<std::string>& views);

}  // namespace lancer::app
