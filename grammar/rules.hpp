#pragma once
// The grammar, bottom-up, one struct a production. White space and comments are taken behind each token. A
// rule asks the Builder for context where the text alone does not decide: whether a bare comparison is
// allowed here, which kind's attributes a word may be. `must<>` stands only behind a token that commits.

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze_traits.hpp>

#include "grammar/combinators.hpp"

namespace lancer::grammar::rules {

// --- Tokens
// --------------------------------------------------------------------------------------------------

/// A token ends here: its end is noted, and what is blank behind it is skipped.
template <class Rule>
struct tok : p::seq<Rule, token_end, blank> {};

struct comma : tok<p::one<','>> {};
struct semicolon : tok<p::one<';'>> {};
struct colon : tok<p::one<':'>> {};
struct question : tok<p::one<'?'>> {};
struct arrow : tok<p::string<'-', '>'>> {};
/// `=`, but not the start of `==`.
struct equals : tok<p::seq<p::one<'='>, p::not_at<p::one<'='>>>> {};
struct open_paren : tok<p::one<'('>> {};
struct close_paren : tok<p::one<')'>> {};
struct open_bracket : tok<p::one<'['>> {};
struct close_bracket : tok<p::one<']'>> {};
struct open_brace : tok<p::one<'{'>> {};
struct close_brace : tok<p::one<'}'>> {};
struct open_angle : tok<p::one<'<'>> {};
struct close_angle : tok<p::one<'>'>> {};

template <char... Letters>
struct word : tok<p::seq<p::string<Letters...>, p::not_at<p::identifier_other>>> {};
struct k_let : word<'l', 'e', 't'> {};
struct k_fn : word<'f', 'n'> {};
struct k_return : word<'r', 'e', 't', 'u', 'r', 'n'> {};
struct k_if : word<'i', 'f'> {};
struct k_else : word<'e', 'l', 's', 'e'> {};
struct k_for : word<'f', 'o', 'r'> {};
struct k_in : word<'i', 'n'> {};
struct k_while : word<'w', 'h', 'i', 'l', 'e'> {};
struct k_break : word<'b', 'r', 'e', 'a', 'k'> {};
struct k_continue : word<'c', 'o', 'n', 't', 'i', 'n', 'u', 'e'> {};
struct k_include : word<'i', 'n', 'c', 'l', 'u', 'd', 'e'> {};
struct k_modify : word<'m', 'o', 'd', 'i', 'f', 'y'> {};
struct k_remove : word<'r', 'e', 'm', 'o', 'v', 'e'> {};
struct k_settings : word<'s', 'e', 't', 't', 'i', 'n', 'g', 's'> {};
struct k_true : word<'t', 'r', 'u', 'e'> {};
struct k_false : word<'f', 'a', 'l', 's', 'e'> {};
struct k_and : word<'a', 'n', 'd'> {};
struct k_or : word<'o', 'r'> {};
struct k_not : word<'n', 'o', 't'> {};

/// Any identifier, reserved or not: what stands behind the point of a member.
struct member_name : tok<p::identifier> {};
/// An identifier that is no reserved word.
struct name : tok<plain_identifier> {};

struct expression;

// --- Literals
// ------------------------------------------------------------------------------------------------

struct number : tok<number_text> {};
/// `#f80`
struct color : tok<color_text> {};
struct truth : p::sor<k_true, k_false> {};

struct string_text : p::plus<p::not_one<'"', '\\', '{', '\n'>> {};
/// A backslash and what belongs to it, known or not.
struct string_escape
    : p::seq<p::one<'\\'>,
             p::sor<p::seq<p::string<'u', '{'>, p::star<p::alnum>, p::opt<p::one<'}'>>>, p::not_one<'\n'>>> {
};
struct close_interpolation : p::seq<p::one<'}'>, token_end> {};
/// `{expression}` in a string.
struct interpolation : bracketed<p::seq<p::one<'{'>, token_end, blank>,
                                 p::must<with_comparisons<true, expression>>, p::must<close_interpolation>> {
};
struct string_end : p::one<'"'> {};
struct string : tok<bracketed<p::one<'"'>, p::star<p::sor<string_text, string_escape, interpolation>>,
                              p::must<string_end>>> {};

// --- Values
// --------------------------------------------------------------------------------------------------

/// An expression that may begin here or must.
struct value : with_comparisons<false, expression> {};
struct open_value : with_comparisons<true, expression> {};

/// `<1, 2, 3>` or `<1, 2>`
struct vector : bracketed<open_angle, p::must<value>, p::must<comma>, p::must<value>,
                          p::opt<comma, p::must<value>>, p::must<close_angle>> {};
struct comma_or_bracket : p::sor<p::seq<comma, p::opt<p::at<p::one<']'>>>>, p::at<p::one<']'>>> {};
/// `[a, b, c]`, with a trailing comma or without.
struct list
    : bracketed<open_bracket, p::star<open_value, p::must<comma_or_bracket>>, p::must<close_bracket>> {};
struct parenthesis : bracketed<open_paren, p::must<open_value>, p::must<close_paren>> {};
struct constructed;
struct variable : name {};

struct comma_or_paren : p::sor<comma, p::at<p::one<')'>>> {};
struct fallback : p::if_must<equals, open_value> {};
struct parameter_name : name {};
struct parameter : p::seq<parameter_name, p::opt<fallback>> {};
/// `(a, b = 2)`
struct end_of_parameters : close_paren {};
struct parameters
    : bracketed<open_paren, p::star<parameter, p::must<comma_or_paren>>, p::must<end_of_parameters>> {};
struct scope;
struct function_scope : in_function<scope> {};
/// The value that an expression body gives: loops around the function are not its own.
struct body_value : in_function<open_value> {};
struct arrow_body : p::if_must<arrow, body_value> {};
struct function_body : p::sor<arrow_body, function_scope> {};
/// `fn (a) -> a + 1` or `fn (a) { ... }`
struct function : p::if_must<k_fn, parameters, function_body> {};

struct primary
    : p::sor<number, string, vector, list, parenthesis, truth, function, constructed, variable, color> {};

// --- Operators, tightest first
// -------------------------------------------------------------------------------

/// `(a, b)` on the line on which what is called ends.
struct call
    : p::seq<same_line,
             bracketed<open_paren, p::star<open_value, p::must<comma_or_paren>>, p::must<close_paren>>> {};
/// `[i]`, likewise.
struct index : p::seq<same_line, bracketed<open_bracket, p::must<open_value>, p::must<close_bracket>>> {};
struct member : p::if_must<tok<p::seq<p::one<'.'>, p::not_at<p::one<'.'>>>>, member_name> {};
struct postfix : p::seq<primary, p::star<p::sor<call, index, member>>> {};

struct exponent;
struct raise_sign : tok<p::one<'^'>> {};
/// base ^ exponent, from the right.
struct raised : p::seq<raise_sign, p::must<exponent>> {};
struct power : p::seq<postfix, p::opt<raised>> {};
struct sign : tok<p::one<'-', '+'>> {};
struct signed_exponent : p::seq<sign, p::must<deeper<exponent>>> {};
struct exponent : p::sor<signed_exponent, deeper<power>> {};

struct unary;
struct signed_value : p::seq<sign, p::must<deeper<unary>>> {};
struct unary : p::sor<signed_value, power> {};

/// No operator of this language is followed by `=` or doubled; `+=` is told where the statement begins.
struct multiply_sign : tok<p::seq<p::one<'*', '/', '%'>, p::not_at<p::one<'=', '*'>>>> {};
struct factor : p::seq<unary> {};
struct product : p::seq<unary, p::star<multiply_sign, p::must<factor>>> {};
struct add_sign : tok<p::seq<p::one<'+', '-'>, p::not_at<p::one<'='>>>> {};
struct term : p::seq<product> {};
struct sum : p::seq<product, p::star<add_sign, p::must<term>>> {};

struct closed_range_sign : tok<p::string<'.', '.', '='>> {};
struct open_range_sign : tok<p::seq<p::string<'.', '.'>, p::not_at<p::one<'='>>>> {};
struct bound : p::seq<sum> {};
struct closed_range : p::seq<closed_range_sign, p::must<bound>> {};
struct open_range : p::seq<open_range_sign, p::must<bound>> {};
struct chained_range : p::if_must<p::sor<closed_range_sign, open_range_sign>, bound> {};
/// `a..b` and `a..=b`, which do not chain.
struct range : p::seq<sum, p::opt<p::sor<closed_range, open_range>, p::opt<chained_range>>> {};

struct compare_sign : tok<p::sor<p::string<'=', '='>, p::string<'!', '='>, p::string<'<', '='>,
                                 p::string<'>', '='>, p::one<'<', '>'>>> {};
struct compared : p::seq<range> {};
/// a < b: one comparison; more of them are told.
struct comparison : p::seq<range, p::star<comparisons_allowed, compare_sign, p::must<compared>>> {};

struct inversion;
struct negation : p::seq<k_not, p::must<deeper<inversion>>> {};
struct inversion : p::sor<negation, comparison> {};
struct conjunct : p::seq<inversion> {};
struct conjunction : p::seq<inversion, p::star<k_and, p::must<conjunct>>> {};
struct disjunct : p::seq<conjunction> {};
struct disjunction : p::seq<conjunction, p::star<k_or, p::must<disjunct>>> {};
struct alternative : p::seq<expression> {};
/// c ? a : b
struct choice : p::seq<question, p::must<alternative>, p::must<colon>, p::must<alternative>> {};
struct conditional : p::seq<disjunction, p::opt<choice>> {};
struct expression : deeper<conditional> {};

// --- Blocks of objects and materials
// -------------------------------------------------------------------------

struct attribute_name : tok<known_attribute> {};
struct first_value : value {};
struct next_value : value {};
struct values : p::seq<first_value, p::star<comma, p::must<next_value>>> {};
struct plain_attribute : p::seq<attribute_name, p::must<values>> {};

struct block_body;
/// `material { ... }`: short for `material material { ... }`.
struct short_material
    : p::seq<p::at<material_attribute>, tok<p::identifier>, in_material<deeper<block_body>>> {};

/// A name that is no attribute of this kind, with what seems to be its values.
struct unknown_name : tok<unknown_attribute_name> {};
struct unknown_attribute
    : p::seq<unknown_name, p::sor<p::at<p::one<'}'>>, foreign_braces, p::opt<values>>, leftovers> {};

struct attribute : p::sor<short_material, plain_attribute> {};
struct positional : p::seq<positional_start, first_value, p::star<comma, p::must<next_value>>> {};
struct block_item : p::sor<semicolon, attribute, unknown_attribute> {};
struct end_of_block : close_brace {};
struct plain_braces : bracketed<open_brace, p::opt<positional>, p::star<block_item>, p::must<end_of_block>> {
};

struct statement;
struct checked_statement;
/// An attribute among the statements of a group.
struct unknown_in_group : p::seq<p::at<unknown_group_attribute>, unknown_name, forgiving<p::opt<values>>> {};
struct group_attribute : p::sor<attribute, unknown_in_group> {};
struct group_item : p::sor<semicolon, recovering<group_attribute>, checked_statement> {};
struct group_braces
    : bracketed<open_brace, in_block<p::star<p::not_at<p::one<'}'>>, p::not_at<p::eof>, group_item>>,
                p::must<close_brace>> {};
struct block_body : p::sor<p::seq<kind_is_group, p::must<group_braces>>, p::must<plain_braces>> {};

struct block_name : string {};
struct kind_word : tok<kind_identifier> {};
/// kind "name" { ... }
struct constructed : p::seq<kind_word, in_kind<p::seq<p::opt<block_name>, block_body>>> {};

// --- Statements
// ----------------------------------------------------------------------------------------------

struct scope_braces
    : bracketed<open_brace,
                in_block<p::star<
                    p::sor<semicolon, p::seq<p::not_at<p::one<'}'>>, p::not_at<p::eof>, checked_statement>>>>,
                p::must<close_brace>> {};
/// Statements in braces.
struct scope : deeper<scope_braces> {};

struct let_name : name {};
struct let_equals : equals {};
struct let : p::if_must<k_let, let_name, let_equals, open_value> {};

struct function_name : name {};
struct equals_body : p::if_must<equals, body_value> {};
struct named_body : p::sor<equals_body, function_scope> {};
struct function_statement
    : p::seq<p::at<k_fn, p::not_at<p::one<'('>>>, p::if_must<k_fn, function_name, parameters, named_body>> {};

struct condition : open_value {};
struct branch_scope : p::seq<scope> {};
struct branch;
struct else_part
    : p::seq<k_else, p::sor<p::seq<k_if, p::must<condition, branch_scope>>, p::must<branch_scope>>> {};
struct branch : p::seq<k_if, p::must<condition, branch_scope>, p::star<else_part>> {};

struct loop_scope : in_loop<scope> {};
struct for_name : name {};
struct sequence : open_value {};
struct for_loop : p::if_must<k_for, for_name, k_in, sequence, loop_scope> {};
struct while_loop : p::if_must<k_while, condition, loop_scope> {};
struct break_loop : k_break {};
struct continue_loop : k_continue {};
struct give_back : p::seq<k_return, p::sor<p::at<p::one<'}', ';'>>, p::at<p::eof>, p::must<open_value>>> {};

struct path : string {};
struct include : p::if_must<k_include, path> {};
struct pattern_name : string {};
struct modify_braces : bracketed<open_brace, p::star<block_item>, p::must<end_of_block>> {};
struct modify : p::seq<k_modify, p::must<pattern_name>, in_any_kind<p::must<modify_braces>>> {};
struct remove : p::if_must<k_remove, pattern_name> {};
struct settings_braces : plain_braces {};
struct settings : p::seq<k_settings, in_settings<p::must<settings_braces>>> {};

struct target : name {};
struct assign
    : p::seq<p::at<name, p::one<'='>, p::not_at<p::one<'='>>>, target, equals, p::must<open_value>> {};
struct expression_statement : open_value {};

struct statement
    : p::seq<not_foreign,
             p::sor<let, function_statement, branch, for_loop, while_loop, break_loop, continue_loop,
                    give_back, include, modify, remove, settings, assign, expression_statement>> {};
/// A statement, or a mistake that is reported and skipped.
struct checked_statement : recovering<p::must<statement>> {};

struct stray_brace : tok<p::one<'}'>> {};
struct script
    : p::seq<byte_order_mark, blank, p::until<p::eof, p::sor<semicolon, stray_brace, checked_statement>>> {};

}  // namespace lancer::grammar::rules
