#pragma once
// What stands at the top level of a script's text, and edits of that text which leave all else as it is.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::session {

/// A statement at the top level; offsets are bytes in the text.
struct Item {
  enum class Kind { variable, function, object, expression, other };
  Kind kind = Kind::other;
  std::string name;  // of a `let`, `fn` or object; empty where it has none, or one with `{..}` in it
  std::size_t begin = 0, end = 0;
  std::size_t name_begin = 0, name_end = 0;  // quotes included
};

struct Outline {
  std::vector<Item> items;
  bool is_wrong = false;       // the text has syntax errors
  bool is_incomplete = false;  // the one thing wrong is that it ends too early
};

Outline outline_of(std::string_view text);

/// The item that declares or names it, the last one of that name; null where there is none.
const Item* find_item(const Outline& outline, Item::Kind kind, std::string_view name);

std::string_view text_of(std::string_view text, const Item& item);
/// Without the item, and without the lines that it had to itself.
std::string without(std::string_view text, const Item& item);
std::string replaced(std::string_view text, const Item& item, std::string_view by);
/// With an entry behind all else, on lines of its own.
std::string appended(std::string_view text, std::string_view entry);
/// A name as a script writes it, in quotes.
std::string quoted_name(std::string_view name);

}  // namespace lancer::session
