#pragma once
// The grammar's smallest rules: those that take characters by a function of `lexemes` or look ahead, some of
// them with an eye on the Builder's context.

#include <algorithm>
#include <string_view>
#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze_traits.hpp>

#include "grammar/builder.hpp"
#include "grammar/failure.hpp"
#include "grammar/foreign.hpp"
#include "grammar/lexemes.hpp"
#include "lang/keywords.hpp"

namespace lancer::grammar::rules {

namespace p = tao::pegtl;

/// A rule that matches what `Scanner::scan(at, end, builder)` takes; nothing taken is no match.
template <class Scanner>
struct scanned {
  using rule_t = scanned;
  using subs_t = p::empty_list;
  template <p::apply_mode, p::rewind_mode, template <class...> class, template <class...> class, class Input>
  static bool match(Input& in, Builder& b) {
    const char* behind = Scanner::scan(in.current(), in.end(), b);
    if (behind == in.current()) return false;
    in.bump(static_cast<std::size_t>(behind - in.current()));
    return true;
  }
};

/// A rule that takes nothing and matches where `Test::test(at, end, builder)` holds.
template <class Test>
struct tested {
  using rule_t = tested;
  using subs_t = p::empty_list;
  template <p::apply_mode, p::rewind_mode, template <class...> class, template <class...> class, class Input>
  static bool match(Input& in, Builder& b) {
    return Test::test(in.current(), in.end(), b);
  }
};

/// White space and comments, or nothing.
struct blank {
  using rule_t = blank;
  using subs_t = p::empty_list;
  template <p::apply_mode, p::rewind_mode, template <class...> class, template <class...> class, class Input>
  static bool match(Input& in, Builder& b) {
    const char* unclosed = nullptr;
    const char* behind = skip_blank(in.current(), in.end(), &unclosed);
    if (unclosed != nullptr) fail_unclosed_comment(b, unclosed);
    in.bump(static_cast<std::size_t>(behind - in.current()));
    return true;
  }
};

/// Marks the end of a token; its action notes the place.
struct token_end : p::success {};

struct byte_order_mark : p::opt<p::string<'\xEF', '\xBB', '\xBF'>> {};

struct ScanNumber {
  static const char* scan(const char* at, const char* end, Builder&) { return scan_number(at, end); }
};
struct number_text : scanned<ScanNumber> {};

struct ScanColor {
  static const char* scan(const char* at, const char* end, Builder& b) {
    if (at == end || *at != '#') return at;
    const char* behind = scan_color(at, end);
    fail_if_directive(b, at, behind);
    return behind;
  }
};
struct color_text : scanned<ScanColor> {};

inline const char* behind_word(const char* at, std::string_view word) { return at + word.size(); }

struct ScanPlainIdentifier {
  static const char* scan(const char* at, const char* end, Builder&) {
    const std::string_view word = word_at(at, end);
    return word.empty() || lang::is_reserved(word) ? at : behind_word(at, word);
  }
};
struct plain_identifier : scanned<ScanPlainIdentifier> {};

struct ScanKind {
  static const char* scan(const char* at, const char* end, Builder& b) {
    const std::string_view word = word_at(at, end);
    const auto kind = word.empty() ? std::nullopt : lang::find_kind(word);
    if (!kind || *kind == ast::Kind::settings) return at;
    b.pending_kind = *kind;
    return behind_word(at, word);
  }
};
struct kind_identifier : scanned<ScanKind> {};

inline bool is_attribute(const Builder& b, std::string_view word) {
  if (word.empty()) return false;
  if (b.any_kind) return lang::find_attribute(word) != nullptr;
  return !b.kinds.empty() && lang::find_attribute(b.kinds.back(), word) != nullptr;
}

struct ScanAttribute {
  static const char* scan(const char* at, const char* end, Builder& b) {
    const std::string_view word = word_at(at, end);
    if (!is_attribute(b, word)) return at;
    const char* next = behind_blank(behind_word(at, word), end);
    const bool assigned = !b.any_kind && b.kinds.back() == ast::Kind::group && next != end && *next == '=' &&
                          !(next + 1 != end && next[1] == '=');
    return assigned ? at : behind_word(at, word);
  }
};
struct known_attribute : scanned<ScanAttribute> {};

struct IsMaterialAttribute {
  static bool test(const char* at, const char* end, Builder& b) {
    const std::string_view word = word_at(at, end);
    const char* next = behind_blank(behind_word(at, word), end);
    return word == "material" && is_attribute(b, word) && next != end && *next == '{';
  }
};
struct material_attribute : tested<IsMaterialAttribute> {};

/// A name where an attribute should stand. Words of statements are not taken: before them a `}` is missing.
struct ScanUnknownAttribute {
  static const char* scan(const char* at, const char* end, Builder&) {
    const std::string_view word = word_at(at, end);
    const bool taken = !word.empty() && (!lang::is_reserved(word) || word == "material");
    return taken ? behind_word(at, word) : at;
  }
};
struct unknown_attribute_name : scanned<ScanUnknownAttribute> {};

/// In a group, a name directly before `<`.
struct IsUnknownGroupAttribute {
  static bool test(const char* at, const char* end, Builder&) {
    const std::string_view word = word_at(at, end);
    const char* next = behind_blank(behind_word(at, word), end);
    return !word.empty() && !lang::is_reserved(word) && next != end && *next == '<';
  }
};
struct unknown_group_attribute : tested<IsUnknownGroupAttribute> {};

/// `{ ... }` behind an unknown attribute: another language's block, which is passed over.
struct ScanForeignBraces {
  static const char* scan(const char* at, const char* end, Builder& b) {
    return at != end && *at == '{' ? skip_braces(b.text(), at) : at;
  }
};
struct foreign_braces : p::seq<scanned<ScanForeignBraces>, token_end, blank> {};

/// What stands between the values of an unknown attribute and the next name: part of the same mistake.
struct ScanLeftovers {
  static const char* scan(const char* at, const char* end, Builder& b) {
    while (at != end && *at != '}' && *at != ';' && word_at(at, end).empty()) {
      const char* number = scan_number(at, end);
      at = *at == '"'     ? skip_string(at, end)
           : *at == '{'   ? skip_braces(b.text(), at)
           : number != at ? number
                          : at + 1;
      at = behind_blank(at, end);
    }
    return at;
  }
};
struct leftovers : p::opt<scanned<ScanLeftovers>> {};

/// Whether the values without attribute names begin here, at the start of a block.
struct IsPositional {
  static bool test(const char* at, const char* end, Builder& b) {
    if (at == end || *at == '}' || *at == ';') return false;
    const std::string_view word = word_at(at, end);
    if (word.empty()) return true;
    if (is_attribute(b, word)) return false;
    if (lang::is_reserved(word))
      return word == "true" || word == "false" || word == "not" || word == "fn" || lang::find_kind(word);
    if (!b.kinds.empty() && lang::kind_info(b.kinds.back()).max_positional == 0) return false;
    const char* next = behind_blank(behind_word(at, word), end);
    if (next == end) return true;
    const std::string_view next_word = word_at(next, end);
    if (!next_word.empty()) {
      return next_word == "and" || next_word == "or" || is_attribute(b, next_word) || next_word == "material";
    }
    const bool begins_value =
        *next == '<' || *next == '"' || *next == '#' || *next == '{' || scan_number(next, end) != next;
    return !begins_value;
  }
};
struct positional_start : tested<IsPositional> {};

struct IsSameLine {
  static bool test(const char* at, const char*, Builder& b) {
    const char* last = b.text().data() + b.last_end;
    return std::find(last, at, '\n') == at;
  }
};
struct same_line : tested<IsSameLine> {};

struct AreComparisonsAllowed {
  static bool test(const char* at, const char* end, Builder& b) {
    if (b.comparisons) fail_if_foreign_color(b, at, end);
    return b.comparisons;
  }
};
struct comparisons_allowed : tested<AreComparisonsAllowed> {};

struct IsGroup {
  static bool test(const char*, const char*, Builder& b) {
    return !b.kinds.empty() && b.kinds.back() == ast::Kind::group;
  }
};
struct kind_is_group : tested<IsGroup> {};

/// Tells habits from other languages before they make confusing errors.
struct IsNotForeign {
  static bool test(const char* at, const char* end, Builder& b) {
    fail_if_foreign_statement(b, at, end);
    return true;
  }
};
struct not_foreign : tested<IsNotForeign> {};

}  // namespace lancer::grammar::rules

namespace TAO_PEGTL_NAMESPACE {

template <class Name, class Scanner>
struct analyze_traits<Name, lancer::grammar::rules::scanned<Scanner>> : analyze_any_traits<> {};
template <class Name, class Test>
struct analyze_traits<Name, lancer::grammar::rules::tested<Test>> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::rules::blank> : analyze_opt_traits<> {};

}  // namespace TAO_PEGTL_NAMESPACE
