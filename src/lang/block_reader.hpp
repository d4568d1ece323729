#pragma once
// The values of a block by the names of its attributes, whichever form they were written in, and checks of
// what each may be. Every refusal is a ScriptError at the value at fault.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/build_object.hpp"
#include "lang/object.hpp"

namespace lancer::lang {

/// One value of an attribute, and where it was written.
struct Argument {
  const Value* value;
  Span span;
  ast::Kind kind;       // of the block
  std::string_view id;  // of the attribute
};

/// All values of an attribute.
struct Slot {
  ast::Kind kind;
  std::string_view id;
  std::span<const Value> values;
  std::span<ast::Expr* const> places;

  Argument operator[](std::size_t i) const { return {&values[i], places[i]->span, kind, id}; }
  Argument one() const { return (*this)[0]; }
  std::size_t size() const { return values.size(); }
  Span span() const { return join(places.front()->span, places.back()->span); }
};

/// The name under which the distance in `plane { n, d }` is kept; it is no attribute.
inline constexpr std::string_view k_plane_distance = "distance";

class BlockReader {
 public:
  explicit BlockReader(const BlockValues& values) : values_(values), kind_(values.block->block_kind) {}

  /// The last value that `id` was given; values without names count as given to the attributes they fill.
  std::optional<Slot> find(std::string_view id) const;
  /// The same, where the form cannot do without. Throws ScriptError(missing_attribute).
  Slot need(std::string_view id) const;
  bool has(std::string_view id) const { return find(id).has_value(); }

  /// What members read: everything but transforms, material and shadow.
  std::vector<Written> written() const;

  ast::Kind kind() const { return kind_; }
  Span kind_span() const { return values_.block->kind_span; }
  const BlockValues& values() const { return values_; }

 private:
  const BlockValues& values_;
  ast::Kind kind_;
};

// --- What a value may be
// --------------------------------------------------------------------------------------

/// "a sphere's radius", "an ior".
std::string subject(const Argument& argument);
/// "a number", "a vector of 2".
std::string found_text(const Value& value);
/// "<0, 1, 0>".
std::string to_text(Vec3 v);
/// The same, or one number for a grey.
std::string to_text(Color c);
bool has_negative(Color c);

/// A refusal at the argument: "<subject> <rule>; this one is <found>".
[[noreturn]] void refuse(Code code, const Argument& argument, std::string_view rule, std::string_view found,
                         std::string help = {});
/// "<subject> is <wanted>; this is a string".
[[noreturn]] void refuse_type(const Argument& argument, std::string_view wanted, std::string help = {});

double read_number(const Argument& argument);
/// > 0.
double read_positive(const Argument& argument);
/// >= 0.
double read_not_negative(const Argument& argument);
/// A whole number in [lowest, highest].
int read_whole(const Argument& argument, int lowest, int highest);
/// Degrees in (0, 180).
double read_opening(const Argument& argument);
bool read_boolean(const Argument& argument);
/// Three numbers; a number is no point.
Vec3 read_point(const Argument& argument);
/// Three numbers, not all 0.
Vec3 read_direction(const Argument& argument);
/// A vector of three or a number, grey. Components may be negative.
Color read_color(const Argument& argument);

}  // namespace lancer::lang
