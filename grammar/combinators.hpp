#pragma once
// The grammar's own combinators: rules that look at or change the Builder's context while the rule inside them is
// matched. The context is put back however that ends.

#include <algorithm>
#include <cctype>
#include <string_view>

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze_traits.hpp>

#include "grammar/builder.hpp"
#include "grammar/failure.hpp"
#include "grammar/lexemes.hpp"
#include "lang/keywords.hpp"

namespace lancer::grammar::rules {

namespace p = tao::pegtl;

inline constexpr int k_max_depth = 1000;

/// Sets a variable, and puts the old value back at the end of the scope.
template <class T>
class Restore {
 public:
  Restore(T& target, T value) : target_(target), old_(std::exchange(target, value)) {}
  ~Restore() { target_ = old_; }
  Restore(const Restore&) = delete;
  Restore& operator=(const Restore&) = delete;

 private:
  T& target_;
  T old_;
};

// --- Rules that take characters by a scanner of their own ------------------------------------------------------

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
  static bool match(Input& in, Builder& b) { return Test::test(in.current(), in.end(), b); }
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

inline const char* behind_blank(const char* at, const char* end) {
  const char* unclosed = nullptr;
  return skip_blank(at, end, &unclosed);
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
      at = *at == '"' ? skip_string(at, end) : *at == '{' ? skip_braces(b.text(), at) : number != at ? number : at + 1;
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
    if (lang::is_reserved(word)) return word == "true" || word == "false" || word == "not" || word == "fn" || lang::find_kind(word);
    if (!b.kinds.empty() && lang::kind_info(b.kinds.back()).max_positional == 0) return false;
    const char* next = behind_blank(behind_word(at, word), end);
    if (next == end) return true;
    const std::string_view next_word = word_at(next, end);
    if (!next_word.empty()) {
      return next_word == "and" || next_word == "or" || is_attribute(b, next_word) || next_word == "material";
    }
    const bool begins_value = *next == '<' || *next == '"' || *next == '#' || *next == '{' || scan_number(next, end) != next;
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
  static bool test(const char*, const char*, Builder& b) { return !b.kinds.empty() && b.kinds.back() == ast::Kind::group; }
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

// --- Rules around rules ---------------------------------------------------------------------------------------

/// Matches `Rule` by way of Control, so that actions and messages work as for any rule.
template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control,
          class Rule, class Input>
bool match_rule(Input& in, Builder& b) {
  return Control<Rule>::template match<A, M, Action, Control>(in, b);
}

template <bool Allowed, class Rule>
struct with_comparisons {
  using rule_t = with_comparisons;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const Restore<bool> restore(b.comparisons, Allowed);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

/// One level deeper in blocks and expressions; too deep ends the parse.
template <class Rule>
struct deeper {
  using rule_t = deeper;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    if (b.depth >= k_max_depth) fail_too_deep(b, in.current());
    const Restore<int> restore(b.depth, b.depth + 1);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

/// An opening token, what follows it, its closing token among that. Open brackets are known while it lasts.
template <class Open, class... Rest>
struct bracketed {
  using rule_t = bracketed;
  using subs_t = p::type_list<Open, Rest...>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const std::uint32_t at = b.offset(in.current());
    if (!match_rule<A, M, Action, Control, Open>(in, b)) return false;
    struct Pop {
      std::vector<std::uint32_t>& brackets;
      ~Pop() { brackets.pop_back(); }
    };
    b.brackets.push_back(at);
    const Pop pop{b.brackets};
    return (match_rule<A, p::rewind_mode::dontcare, Action, Control, Rest>(in, b) && ...);
  }
};

template <class Rule>
struct in_function {
  using rule_t = in_function;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const Restore<bool> function(b.in_function, true);
    const Restore<int> loops(b.loops, 0);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

template <class Rule>
struct in_loop {
  using rule_t = in_loop;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const Restore<int> loops(b.loops, b.loops + 1);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

/// Within braces: not at the top level of the file.
template <class Rule>
struct in_block {
  using rule_t = in_block;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const Restore<int> blocks(b.blocks, b.blocks + 1);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

/// Pushes a kind for as long as its block lasts.
class KindScope {
 public:
  KindScope(Builder& b, ast::Kind kind) : kinds_(b.kinds), any_(b.any_kind, false) { kinds_.push_back(kind); }
  ~KindScope() { kinds_.pop_back(); }
  KindScope(const KindScope&) = delete;
  KindScope& operator=(const KindScope&) = delete;

 private:
  std::vector<ast::Kind>& kinds_;
  Restore<bool> any_;
};

/// Within the block of the kind whose word was just read.
template <class... Rules>
struct in_kind {
  using rule_t = in_kind;
  using subs_t = p::type_list<Rules...>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const KindScope scope(b, b.pending_kind);
    return (match_rule<A, p::rewind_mode::dontcare, Action, Control, Rules>(in, b) && ...);
  }
};

template <ast::Kind Kind, class Rule>
struct in_given_kind {
  using rule_t = in_given_kind;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const KindScope scope(b, Kind);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};
template <class Rule>
using in_material = in_given_kind<ast::Kind::material, Rule>;
template <class Rule>
using in_settings = in_given_kind<ast::Kind::settings, Rule>;

/// Within the block of `modify`, where any kind's attribute may stand.
template <class Rule>
struct in_any_kind {
  using rule_t = in_any_kind;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const Restore<bool> any(b.any_kind, true);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

/// Matches `Rule`; where it throws, the message is kept, what it left on the stacks is dropped, and the text is skipped
/// to where the next statement may begin.
template <class Rule>
struct recovering {
  using rule_t = recovering;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const char* start = in.current();
    const Builder::Mark mark = b.mark();
    const char* target = nullptr;
    try {
      return match_rule<A, M, Action, Control, Rule>(in, b);
    } catch (SyntaxError& problem) {
      if (problem.last) throw;
      target = recover(b, problem, start, mark);
    }
    in.bump(static_cast<std::size_t>(std::max(target, in.current()) - in.current()));
    const char* behind = behind_blank(in.current(), in.end());
    in.bump(static_cast<std::size_t>(behind - in.current()));
    return true;
  }
};

/// Matches `Rule`, which belongs to a mistake that is reported already: where it throws, the text is skipped in silence.
template <class Rule>
struct forgiving {
  using rule_t = forgiving;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action, template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const char* start = in.current();
    const Builder::Mark mark = b.mark();
    try {
      return match_rule<A, M, Action, Control, Rule>(in, b);
    } catch (SyntaxError& problem) {
      if (problem.last) throw;
      b.reset(mark);
      const char* target = end_of_mistake(b, problem, start);
      in.bump(static_cast<std::size_t>(std::max(target, in.current()) - in.current()));
      return true;
    }
  }
};

}  // namespace lancer::grammar::rules

namespace TAO_PEGTL_NAMESPACE {

namespace g = lancer::grammar::rules;

template <class Name, class Scanner>
struct analyze_traits<Name, g::scanned<Scanner>> : analyze_any_traits<> {};
template <class Name, class Test>
struct analyze_traits<Name, g::tested<Test>> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, g::blank> : analyze_opt_traits<> {};
template <class Name, bool Allowed, class Rule>
struct analyze_traits<Name, g::with_comparisons<Allowed, Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class Rule>
struct analyze_traits<Name, g::deeper<Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class... Rules>
struct analyze_traits<Name, g::bracketed<Rules...>> : analyze_seq_traits<Rules...> {};
template <class Name, class Rule>
struct analyze_traits<Name, g::in_function<Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class Rule>
struct analyze_traits<Name, g::in_loop<Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class Rule>
struct analyze_traits<Name, g::in_block<Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class... Rules>
struct analyze_traits<Name, g::in_kind<Rules...>> : analyze_seq_traits<Rules...> {};
template <class Name, lancer::ast::Kind Kind, class Rule>
struct analyze_traits<Name, g::in_given_kind<Kind, Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class Rule>
struct analyze_traits<Name, g::in_any_kind<Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class Rule>
struct analyze_traits<Name, g::recovering<Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class Rule>
struct analyze_traits<Name, g::forgiving<Rule>> : analyze_seq_traits<Rule> {};

}  // namespace TAO_PEGTL_NAMESPACE
