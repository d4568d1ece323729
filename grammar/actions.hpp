#pragma once
// Which part of the Builder each rule calls when it has matched.

#include <functional>
#include <type_traits>

#include "grammar/rules.hpp"

namespace lancer::grammar::rules {

/// Calls a member of the Builder, with where the rule begins and where it ends as far as the member wants to
/// know.
template <auto Member>
struct calls {
  template <class In>
  static void apply(const In& in, Builder& b) {
    if constexpr (std::is_invocable_v<decltype(Member), Builder&, const char*, const char*>) {
      std::invoke(Member, b, in.begin(), in.end());
    } else if constexpr (std::is_invocable_v<decltype(Member), Builder&, const char*>) {
      std::invoke(Member, b, in.begin());
    } else {
      std::invoke(Member, b);
    }
  }
};

template <class Rule>
struct action : p::nothing<Rule> {};

// clang-format off

// Tokens and literals
template <> struct action<token_end> : calls<&Builder::end_token> {};
template <> struct action<number_text> : calls<&Builder::number> {};
template <> struct action<color_text> : calls<&Builder::color> {};
template <> struct action<truth> : calls<&Builder::truth> {};
template <> struct action<string_text> : calls<&Builder::string_text> {};
template <> struct action<string_escape> : calls<&Builder::string_escape> {};
template <> struct action<interpolation> : calls<&Builder::interpolation> {};
template <> struct action<string> : calls<&Builder::string> {};
template <> struct action<path> : calls<&Builder::string> {};
template <> struct action<block_name> : calls<&Builder::string_as_name> {};
template <> struct action<pattern_name> : calls<&Builder::string_as_name> {};

// Names
template <> struct action<variable> : calls<&Builder::name> {};
template <> struct action<let_name> : calls<&Builder::word> {};
template <> struct action<function_name> : calls<&Builder::word> {};
template <> struct action<parameter_name> : calls<&Builder::word> {};
template <> struct action<for_name> : calls<&Builder::word> {};
template <> struct action<member_name> : calls<&Builder::word> {};
template <> struct action<target> : calls<&Builder::word> {};

// Expressions
template <> struct action<vector> : calls<&Builder::vector> {};
template <> struct action<list> : calls<&Builder::list> {};
template <> struct action<parameter> : calls<&Builder::parameter> {};
template <> struct action<function> : calls<&Builder::function> {};
template <> struct action<call> : calls<&Builder::call> {};
template <> struct action<index> : calls<&Builder::index> {};
template <> struct action<member> : calls<&Builder::member> {};
template <> struct action<power> : calls<&Builder::power> {};
template <> struct action<sign> : calls<&Builder::sign> {};
template <> struct action<signed_value> : calls<&Builder::unary> {};
template <> struct action<signed_exponent> : calls<&Builder::unary> {};
template <> struct action<multiply_sign> : calls<&Builder::binary_sign> {};
template <> struct action<add_sign> : calls<&Builder::binary_sign> {};
template <> struct action<product> : calls<&Builder::chain> {};
template <> struct action<sum> : calls<&Builder::chain> {};
template <> struct action<closed_range> : calls<&Builder::closed_range_end> {};
template <> struct action<open_range> : calls<&Builder::open_range_end> {};
template <> struct action<range> : calls<&Builder::range> {};
template <> struct action<compare_sign> : calls<&Builder::compare_sign> {};
template <> struct action<comparison> : calls<&Builder::compare> {};
template <> struct action<negation> : calls<&Builder::negation> {};
template <> struct action<conjunction> : calls<&Builder::conjunction> {};
template <> struct action<disjunction> : calls<&Builder::disjunction> {};
template <> struct action<conditional> : calls<&Builder::conditional> {};

// Blocks
template <> struct action<plain_attribute> : calls<&Builder::attribute> {};
template <> struct action<short_material> : calls<&Builder::short_material> {};
template <> struct action<unknown_attribute> : calls<&Builder::attribute> {};
template <> struct action<unknown_in_group> : calls<&Builder::attribute> {};
template <> struct action<group_attribute> : calls<&Builder::attribute_statement> {};
template <> struct action<constructed> : calls<&Builder::block> {};

// Statements
template <> struct action<scope> : calls<&Builder::scope> {};
template <> struct action<let> : calls<&Builder::let> {};
template <> struct action<function_statement> : calls<&Builder::function_statement> {};
template <> struct action<assign> : calls<&Builder::assign> {};
template <> struct action<branch> : calls<&Builder::branch> {};
template <> struct action<for_loop> : calls<&Builder::for_loop> {};
template <> struct action<while_loop> : calls<&Builder::while_loop> {};
template <> struct action<break_loop> : calls<&Builder::break_loop> {};
template <> struct action<continue_loop> : calls<&Builder::continue_loop> {};
template <> struct action<give_back> : calls<&Builder::give_back> {};
template <> struct action<include> : calls<&Builder::include> {};
template <> struct action<modify> : calls<&Builder::modify> {};
template <> struct action<remove> : calls<&Builder::remove> {};
template <> struct action<settings> : calls<&Builder::settings> {};
template <> struct action<expression_statement> : calls<&Builder::expression_statement> {};
template <> struct action<stray_brace> : calls<&Builder::stray_brace> {};

// clang-format on

}  // namespace lancer::grammar::rules
