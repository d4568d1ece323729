#pragma once
// The grammar's own combinators: rules that change the Builder's context while the rules inside them are
// matched. The context is put back however that ends.

#include <algorithm>
#include <utility>

#include "grammar/scanners.hpp"

namespace lancer::grammar::rules {

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

/// Matches `Rule` by way of Control, so that actions and messages work as for any rule.
template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
          template <class...> class Control, class Rule, class Input>
bool match_rule(Input& in, Builder& b) {
  return Control<Rule>::template match<A, M, Action, Control>(in, b);
}

template <bool Allowed, class Rule>
struct with_comparisons {
  using rule_t = with_comparisons;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const KindScope scope(b, b.pending_kind);
    return (match_rule<A, p::rewind_mode::dontcare, Action, Control, Rules>(in, b) && ...);
  }
};

template <ast::Kind Kind, class Rule>
struct in_given_kind {
  using rule_t = in_given_kind;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const Restore<bool> any(b.any_kind, true);
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

/// Matches `Rule`; where it throws, the message is kept, what it left on the stacks is dropped, and the text
/// is skipped to where the next statement may begin.
template <class Rule>
struct recovering {
  using rule_t = recovering;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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

/// Matches `Rule`, which belongs to a mistake that is reported already: where it throws, the text is skipped
/// in silence.
template <class Rule>
struct forgiving {
  using rule_t = forgiving;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
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
