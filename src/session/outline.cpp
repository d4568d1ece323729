#include "session/outline.hpp"

#include <algorithm>

#include "base/source.hpp"
#include "grammar/parse.hpp"
#include "lang/ast.hpp"

namespace lancer::session {
namespace {

using ast::as;

/// Sets the name where it is plain text.
void take_name(const ast::String& name, Item& item) {
  const bool is_plain = name.parts.empty() || (name.parts.size() == 1 && name.parts.front().value == nullptr);
  if (!is_plain) return;
  item.name = name.parts.empty() ? "" : std::string(name.parts.front().text);
  item.name_begin = name.span.begin;
  item.name_end = name.span.end;
}

Item item_of(const ast::Stmt& statement) {
  Item out;
  out.begin = statement.span.begin;
  out.end = statement.span.end;
  const auto declares = [&](Item::Kind kind, std::string_view name, Span span) {
    out.kind = kind;
    out.name = name;
    out.name_begin = span.begin;
    out.name_end = span.end;
  };
  if (statement.kind == ast::StmtKind::let) {
    const auto& let = as<ast::Let>(statement);
    declares(Item::Kind::variable, let.id, let.id_span);
  } else if (statement.kind == ast::StmtKind::function) {
    const ast::Function& function = *as<ast::FunctionStmt>(statement).function;
    declares(Item::Kind::function, function.id, function.span);
  } else if (statement.kind == ast::StmtKind::expression) {
    const ast::Expr& value = *as<ast::ExprStmt>(statement).value;
    out.kind = value.kind == ast::ExprKind::block ? Item::Kind::object : Item::Kind::expression;
    if (value.kind == ast::ExprKind::block && as<ast::Block>(value).name != nullptr)
      take_name(*as<ast::Block>(value).name, out);
  }
  return out;
}

constexpr std::string_view k_signs = "<>=+-*%^?!.";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

Outline outline_of(std::string_view text) {
  SourceMap sources;
  const grammar::Parsed parsed = grammar::parse(sources, sources.add("", std::string(text)));
  Outline out;
  out.is_wrong = has_errors(parsed.diagnostics);
  out.is_incomplete = parsed.incomplete;
  for (const ast::Stmt* s : parsed.script.statements) out.items.push_back(item_of(*s));
  return out;
}

const Item* find_item(const Outline& outline, Item::Kind kind, std::string_view name) {
  const auto found = std::find_if(outline.items.rbegin(), outline.items.rend(),
                                  [&](const Item& i) { return i.kind == kind && i.name == name; });
  return name.empty() || found == outline.items.rend() ? nullptr : &*found;
}

std::string_view text_of(std::string_view text, const Item& item) {
  return text.substr(item.begin, item.end - item.begin);
}

std::string without(std::string_view text, const Item& item) {
  std::size_t begin = item.begin, end = item.end;
  while (end < text.size() && (is_blank(text[end]) || text[end] == ';')) ++end;
  while (begin > 0 && is_blank(text[begin - 1])) --begin;
  const bool is_first = begin == 0 || text[begin - 1] == '\n';
  if (is_first && end < text.size() && text[end] == '\n') ++end;
  return std::string(text.substr(0, begin)) + (is_first ? "" : " ") + std::string(text.substr(end));
}

std::string replaced(std::string_view text, const Item& item, std::string_view by) {
  return std::string(text.substr(0, item.begin)) + std::string(by) + std::string(text.substr(item.end));
}

std::string appended(std::string_view text, std::string_view entry) {
  std::string out(text);
  if (!out.empty() && out.back() != '\n') out += '\n';
  // A sign at the start of a line would go on with the expression above it.
  if (!out.empty() && !entry.empty() && k_signs.find(entry.front()) != std::string_view::npos) out += ";\n";
  out += entry;
  if (!out.empty() && out.back() != '\n') out += '\n';
  return out;
}

std::string quoted_name(std::string_view name) {
  std::string out = "\"";
  for (const char c : name) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (c == '"' || c == '\\' || c == '{') out += '\\';
    out += c;
  }
  return out + "\"";
}

}  // namespace lancer::session
