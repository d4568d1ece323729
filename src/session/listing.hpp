#pragma once
// What is in a scene, for people: a line for each shape, light and view.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "session/session.hpp"

namespace lancer::session {

struct Listed {
  enum class Sort { shape, light, view };
  Sort sort = Sort::shape;
  std::string kind;  // as written: "cube"
  std::string name;  // or, where it has none, its kind and its place among those: "sphere 2"
  bool is_named = false;
  std::string place;  // "<0, 1, 0>" in the world: a centre, a point of it, an eye, or a direction of light
  std::string look;   // of a shape: the number of its material, from 1, and its diffuse colour
  std::string file;   // where it is written
  std::uint32_t line = 0;
  Span source;
};

/// Shapes, then lights, then views, each in the order in which they were added.
std::vector<Listed> list(const Session& session);

/// Whether a name is as a pattern with `*` and `?` says.
bool name_matches(std::string_view pattern, std::string_view name);

}  // namespace lancer::session
