#pragma once
// The one table of reserved words, kinds and their attributes. The grammar asks it where an attribute begins;
// checks, did-you-mean, completion, highlighters and help read it too.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lang/ast.hpp"

namespace lancer::lang {

inline constexpr std::uint8_t k_any_number = 255;

/// An attribute of a kind, and how many comma-separated values it takes.
struct AttributeInfo {
  std::string_view id;
  std::uint8_t min_values = 1;
  std::uint8_t max_values = 1;
  bool is_transform = false;  // translate, scale, rotate: may be repeated, applied in the order written
};

struct KindInfo {
  ast::Kind kind;
  std::string_view id;
  std::span<const AttributeInfo> attributes;
  std::uint8_t max_positional;  // values before the attributes, at most
};

const KindInfo& kind_info(ast::Kind kind);
std::span<const KindInfo> all_kinds();
std::optional<ast::Kind> find_kind(std::string_view word);

const AttributeInfo* find_attribute(ast::Kind kind, std::string_view word);
/// Any kind's attribute: for `modify`, which does not know the kind.
const AttributeInfo* find_attribute(std::string_view word);

/// `let`, `fn`, ... and the kinds.
bool is_reserved(std::string_view word);
std::span<const std::string_view> statement_words();

/// What people who come from POV-Ray, C, OpenSCAD or Python write, and the Lancer way: ("location", "the eye
/// of a view is `eye`"). Empty when the word rings no bell.
std::string_view foreign_hint(std::string_view word);

}  // namespace lancer::lang
