#pragma once
// What each rule leaves on the Builder's stacks when it has matched.

#include <algorithm>

#include <fmt/format.h>

#include "grammar/rules.hpp"

namespace lancer::grammar::rules {

template <class Rule>
struct action : p::nothing<Rule> {};

/// How many expressions on the stack belong to a rule that begins at `begin`.
inline std::ptrdiff_t operands_since(const Builder& b, const char* begin) {
  const std::uint32_t start = b.offset(begin);
  return std::count_if(b.exprs.rbegin(), std::find_if(b.exprs.rbegin(), b.exprs.rend(), [&](const ast::Expr* e) { return e->span.begin < start; }),
                       [](const ast::Expr*) { return true; });
}

#define LANCER_ACTION(RULE)                                            \
  template <>                                                          \
  struct action<RULE> {                                                \
    template <class In>                                                \
    static void apply([[maybe_unused]] const In& in, [[maybe_unused]] Builder& b)

LANCER_ACTION(token_end) {
    b.previous_end = b.last_end;
    b.last_end = b.offset(in.begin());
  }
};

// --- Literals ---

LANCER_ACTION(number_text) {
    b.last_end = b.offset(in.end());
    b.number(in.begin(), in.end());
  }
};
LANCER_ACTION(color_text) {
    b.last_end = b.offset(in.end());
    b.color(in.begin(), in.end());
  }
};
LANCER_ACTION(truth) { b.push(ast::Boolean{{ast::ExprKind::boolean, b.span(in.begin())}, *in.begin() == 't'}); }
};
LANCER_ACTION(string_text) { b.pieces.push_back({b.offset(in.begin()), {in.begin(), in.end()}, nullptr}); }
};
LANCER_ACTION(string_escape) {
    const std::string_view spelled(in.begin(), static_cast<std::size_t>(in.end() - in.begin()));
    const auto decoded = decode_escape(spelled);
    const std::uint32_t at = b.offset(in.begin());
    if (!decoded) {
      b.report(error(Code::bad_escape, b.span(at, b.offset(in.end())), fmt::format("`{}` is no escape", spelled),
                     "the escapes are \\n \\t \\\" \\\\ \\{ and \\u{1F600}, a Unicode code point in hexadecimal"));
    }
    b.pieces.push_back({at, decoded.value_or(""), nullptr});
  }
};
LANCER_ACTION(interpolation) {
    b.pieces.push_back({b.offset(in.begin()), {}, b.exprs.back()});
    b.exprs.pop_back();
  }
};
LANCER_ACTION(string) { b.string(in.begin()); }
};
LANCER_ACTION(path) { b.string(in.begin()); }
};

inline void named_string(Builder& b, const char* begin) {
  b.string(begin);
  b.names.push_back(static_cast<ast::String*>(b.exprs.back()));
  b.exprs.pop_back();
}
LANCER_ACTION(block_name) { named_string(b, in.begin()); }
};
LANCER_ACTION(pattern_name) { named_string(b, in.begin()); }
};

// --- Names ---

inline void push_word(Builder& b, const char* begin) {
  const Span span = b.span(begin);
  b.words.push_back({span, b.text().substr(span.begin, span.end - span.begin)});
}
LANCER_ACTION(variable) { b.name(in.begin()); }
};
LANCER_ACTION(let_name) { push_word(b, in.begin()); }
};
LANCER_ACTION(function_name) { push_word(b, in.begin()); }
};
LANCER_ACTION(parameter_name) { push_word(b, in.begin()); }
};
LANCER_ACTION(for_name) { push_word(b, in.begin()); }
};
LANCER_ACTION(member_name) { push_word(b, in.begin()); }
};
LANCER_ACTION(target) { push_word(b, in.begin()); }
};

// --- Expressions ---

LANCER_ACTION(vector) { b.vector(in.begin()); }
};
LANCER_ACTION(list) { b.list(in.begin()); }
};
LANCER_ACTION(parameter) { b.parameter(in.begin()); }
};
LANCER_ACTION(function) { b.function(in.begin()); }
};
LANCER_ACTION(call) { b.call(in.begin()); }
};
LANCER_ACTION(index) { b.index(in.begin()); }
};
LANCER_ACTION(member) { b.member(); }
};
LANCER_ACTION(power) {
    if (operands_since(b, in.begin()) == 2) b.power(in.begin());
  }
};
LANCER_ACTION(sign) {
    b.signs.push_back({b.offset(in.begin()), *in.begin() == '-' ? ast::UnaryOp::minus : ast::UnaryOp::plus, 0});
  }
};
LANCER_ACTION(signed_value) { b.unary(in.begin()); }
};
LANCER_ACTION(signed_exponent) { b.unary(in.begin()); }
};
LANCER_ACTION(multiply_sign) {
    const char c = *in.begin();
    const ast::BinaryOp op = c == '*' ? ast::BinaryOp::multiply : c == '/' ? ast::BinaryOp::divide : ast::BinaryOp::modulo;
    b.operators.push_back({b.offset(in.begin()), op, b.previous_end});
  }
};
LANCER_ACTION(add_sign) {
    const ast::BinaryOp op = *in.begin() == '+' ? ast::BinaryOp::add : ast::BinaryOp::subtract;
    b.operators.push_back({b.offset(in.begin()), op, b.previous_end});
  }
};
LANCER_ACTION(product) { b.chain(in.begin()); }
};
LANCER_ACTION(sum) { b.chain(in.begin()); }
};
LANCER_ACTION(closed_range) { b.closed_range = true; }
};
LANCER_ACTION(open_range) { b.closed_range = false; }
};
LANCER_ACTION(range) {
    const std::ptrdiff_t count = operands_since(b, in.begin());
    if (count == 3) {
      b.report(error(Code::chained_comparison, b.span(in.begin()), "ranges do not chain"));
      b.exprs.pop_back();
    }
    if (count >= 2) b.range(in.begin(), b.closed_range);
  }
};
LANCER_ACTION(compare_sign) {
    const char first = *in.begin();
    const bool equal = in.begin()[1] == '=';
    const ast::CompareOp op = first == '=' ? ast::CompareOp::equal
                              : first == '!' ? ast::CompareOp::not_equal
                              : first == '<' ? (equal ? ast::CompareOp::less_equal : ast::CompareOp::less)
                                             : (equal ? ast::CompareOp::greater_equal : ast::CompareOp::greater);
    b.comparers.push_back({b.offset(in.begin()), op, b.previous_end});
  }
};
LANCER_ACTION(comparison) { b.compare(in.begin()); }
};
LANCER_ACTION(negation) {
    b.signs.push_back({b.offset(in.begin()), ast::UnaryOp::logical_not, 0});
    b.unary(in.begin());
  }
};
LANCER_ACTION(conjunction) { b.logical(in.begin(), true); }
};
LANCER_ACTION(disjunction) { b.logical(in.begin(), false); }
};
LANCER_ACTION(conditional) {
    if (operands_since(b, in.begin()) == 3) b.conditional(in.begin());
  }
};

// --- Blocks ---

LANCER_ACTION(plain_attribute) { b.attribute(in.begin()); }
};
LANCER_ACTION(short_material) {
    b.block(in.begin());
    b.attribute(in.begin());
  }
};
LANCER_ACTION(unknown_attribute) { b.attribute(in.begin()); }
};
LANCER_ACTION(unknown_in_group) { b.attribute(in.begin()); }
};
LANCER_ACTION(group_attribute) { b.attribute_statement(in.begin()); }
};
LANCER_ACTION(constructed) { b.block(in.begin()); }
};

// --- Statements ---

LANCER_ACTION(scope) { b.scope(in.begin()); }
};
LANCER_ACTION(let) { b.let(in.begin()); }
};
LANCER_ACTION(function_statement) { b.function_statement(in.begin()); }
};
LANCER_ACTION(assign) { b.assign(in.begin()); }
};
LANCER_ACTION(branch) { b.branch(in.begin()); }
};
LANCER_ACTION(for_loop) { b.for_loop(in.begin()); }
};
LANCER_ACTION(while_loop) { b.while_loop(in.begin()); }
};
LANCER_ACTION(break_loop) {
    if (b.loops == 0) b.report_misplaced(in.begin(), "`break` stands in a loop", "");
    b.push_stmt(ast::Stmt{ast::StmtKind::break_loop, b.span(in.begin())});
  }
};
LANCER_ACTION(continue_loop) {
    if (b.loops == 0) b.report_misplaced(in.begin(), "`continue` stands in a loop", "");
    b.push_stmt(ast::Stmt{ast::StmtKind::continue_loop, b.span(in.begin())});
  }
};
LANCER_ACTION(give_back) {
    if (!b.in_function) b.report_misplaced(in.begin(), "`return` stands in a function", "");
    b.give_back(in.begin());
  }
};
LANCER_ACTION(include) {
    if (b.blocks > 0) b.report_misplaced(in.begin(), "`include` stands at the top level of a file", "move it out of the braces");
    b.include(in.begin());
  }
};
LANCER_ACTION(modify) { b.modify(in.begin()); }
};
LANCER_ACTION(remove) { b.remove(in.begin()); }
};
LANCER_ACTION(settings) {
    if (b.blocks > 0) b.report_misplaced(in.begin(), "`settings` stands at the top level of a file", "move it out of the braces");
    b.settings(in.begin());
  }
};
LANCER_ACTION(expression_statement) { b.expression_statement(); }
};
LANCER_ACTION(stray_brace) {
    if (b.assumed_closers > 0) {
      --b.assumed_closers;
    } else {
      b.report(error(Code::unclosed_bracket, b.span(in.begin()), "this `}` closes nothing"));
    }
  }
};

#undef LANCER_ACTION

}  // namespace lancer::grammar::rules
