#include "grammar/parse.hpp"

#include <algorithm>

#include "base/deep_stack.hpp"
#include "grammar/actions.hpp"
#include "grammar/messages.hpp"

namespace lancer::grammar {
namespace {

template <class Rule>
struct control : tao::pegtl::normal<Rule> {
  template <class In>
  [[noreturn]] static void raise(const In& in, Builder& b) {
    fail(b, in.current(), rules::message<Rule>::value);
  }
};

void parse_into(Builder& b) {
  const std::string_view text = b.text();
  tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy> in(text.data(), text.data() + text.size(), "");
  try {
    if (!tao::pegtl::parse<rules::script, rules::action, control>(in, b))
      fail(b, in.current(), {"a statement"});
  } catch (SyntaxError& problem) {
    b.report(std::move(problem.diagnostic));
  }
}

/// Drops messages about places that are reported already, and puts the rest in the order of the text.
void merge(std::vector<Diagnostic>& into, std::vector<Diagnostic> more) {
  for (Diagnostic& d : more) {
    const auto same_place = [&](const Diagnostic& other) { return other.span.begin == d.span.begin; };
    if (std::none_of(into.begin(), into.end(), same_place)) into.push_back(std::move(d));
  }
  std::stable_sort(into.begin(), into.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.span.begin < b.span.begin; });
}

}  // namespace

Parsed parse(const SourceMap& sources, std::uint32_t file) {
  Parsed out;
  out.script.file = file;
  const std::string_view text = sources[file].text();
  out.diagnostics = check_text(text, file);
  on_deep_stack([&] {
    Builder b(text, file, out.script.arena);
    parse_into(b);
    out.incomplete = b.incomplete && b.diagnostics.size() == 1 && out.diagnostics.empty();
    out.script.statements = out.script.arena.copy(b.stmts.data(), b.stmts.size());
    out.skipped = std::move(b.skipped);
    merge(out.diagnostics, std::move(b.diagnostics));
  });
  return out;
}

}  // namespace lancer::grammar
