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

/// Matches `Rule` while a Guard, made of the Builder and the place, keeps a context.
template <class Guard, class Rule>
struct within {
  using rule_t = within;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
  static bool match(Input& in, Builder& b) {
    const Guard guard(b, in.current());
    return match_rule<A, M, Action, Control, Rule>(in, b);
  }
};

template <bool Allowed>
struct ComparisonsAllowed : Restore<bool> {
  ComparisonsAllowed(Builder& b, const char*) : Restore(b.comparisons, Allowed) {}
};
template <bool Allowed, class Rule>
using with_comparisons = within<ComparisonsAllowed<Allowed>, Rule>;

struct OneDeeper : Restore<int> {
  OneDeeper(Builder& b, const char* at) : Restore(b.depth, b.depth + 1) {
    if (b.depth > k_max_depth) fail_too_deep(b, at);
  }
};
/// One level deeper in blocks and expressions; too deep ends the parse.
template <class Rule>
using deeper = within<OneDeeper, Rule>;

struct Function {
  Restore<bool> function;
  Restore<int> loops;
  Function(Builder& b, const char*) : function(b.in_function, true), loops(b.loops, 0) {}
};
template <class Rule>
using in_function = within<Function, Rule>;

struct Loop : Restore<int> {
  Loop(Builder& b, const char*) : Restore(b.loops, b.loops + 1) {}
};
template <class Rule>
using in_loop = within<Loop, Rule>;

struct Braces : Restore<int> {
  Braces(Builder& b, const char*) : Restore(b.blocks, b.blocks + 1) {}
};
/// Within braces: not at the top level of the file.
template <class Rule>
using in_block = within<Braces, Rule>;

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

struct ReadKind : KindScope {
  ReadKind(Builder& b, const char*) : KindScope(b, b.pending_kind) {}
};
/// Within the block of the kind whose word was just read.
template <class Rule>
using in_kind = within<ReadKind, Rule>;

template <ast::Kind Kind>
struct GivenKind : KindScope {
  GivenKind(Builder& b, const char*) : KindScope(b, Kind) {}
};
template <class Rule>
using in_material = within<GivenKind<ast::Kind::material>, Rule>;
template <class Rule>
using in_settings = within<GivenKind<ast::Kind::settings>, Rule>;

struct AnyKind : Restore<bool> {
  AnyKind(Builder& b, const char*) : Restore(b.any_kind, true) {}
};
/// Within the block of `modify`, where any kind's attribute may stand.
template <class Rule>
using in_any_kind = within<AnyKind, Rule>;

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

/// Matches `Rule`; where it throws, what it left on the stacks is dropped, and the text is skipped to where
/// the next statement may begin. The message is kept where it is `Told`.
template <bool Told, class Rule>
struct resuming {
  using rule_t = resuming;
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
      b.reset(mark);
      target = end_of_mistake(b, problem, start);
      if (Told) tell(b, problem);
    }
    const char* behind = behind_blank(std::max(target, in.current()), in.end());
    in.bump(static_cast<std::size_t>(behind - in.current()));
    return true;
  }
};
template <class Rule>
using recovering = resuming<true, Rule>;
/// For what belongs to a mistake that is told already.
template <class Rule>
using forgiving = resuming<false, Rule>;

}  // namespace lancer::grammar::rules

namespace TAO_PEGTL_NAMESPACE {

namespace g = lancer::grammar::rules;

template <class Name, class Guard, class Rule>
struct analyze_traits<Name, g::within<Guard, Rule>> : analyze_seq_traits<Rule> {};
template <class Name, class... Rules>
struct analyze_traits<Name, g::bracketed<Rules...>> : analyze_seq_traits<Rules...> {};
template <class Name, bool Told, class Rule>
struct analyze_traits<Name, g::resuming<Told, Rule>> : analyze_seq_traits<Rule> {};

}  // namespace TAO_PEGTL_NAMESPACE
