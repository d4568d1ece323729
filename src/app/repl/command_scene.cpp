// :list, :show, :delete and :rename.

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "app/option_values.hpp"
#include "app/repl/commands.hpp"
#include "base/diagnostic.hpp"
#include "session/listing.hpp"
#include "session/outline.hpp"

namespace lancer::app {
namespace {

using session::Item;
using session::Listed;

/// The statement of the text that declares `name`, or that is an object of that name.
const Item* find_any(const session::Outline& outline, std::string_view name) {
  for (const Item::Kind kind : {Item::Kind::object, Item::Kind::variable, Item::Kind::function}) {
    if (const Item* item = find_item(outline, kind, name)) return item;
  }
  return nullptr;
}

/// What the history calls a command: as it was typed, near enough.
std::string label(std::string_view command, const Words& words) {
  std::string out = fmt::format(":{}", command);
  for (const std::string& w : words)
    out += w.find(' ') == std::string::npos ? " " + w : " " + session::quoted_name(w);
  return out;
}

std::optional<Listed> find_listed(const std::vector<Listed>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Listed& l) { return l.name == name; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

[[noreturn]] void nothing_is_named(const session::Outline& outline, const std::vector<Listed>& all,
                                   const std::string& name) {
  std::vector<std::string_view> known;
  for (const Item& item : outline.items) known.push_back(item.name);
  for (const Listed& l : all) known.push_back(l.name);
  const std::string_view near = nearest(name, known);
  throw UsageError(fmt::format(
      "nothing is named \"{}\"{}", name,
      near.empty() ? "; :list shows what there is" : fmt::format("; did you mean \"{}\"?", near)));
}

/// The statement at the top level that an object without a name of its own is.
const Item* item_at(const session::Outline& outline, const Talk& talk, const Listed& listed) {
  if (listed.file != talk.document.name()) return nullptr;
  for (const Item& item : outline.items) {
    if (item.begin == listed.source.begin && item.end == listed.source.end) return &item;
  }
  return nullptr;
}

}  // namespace

void list_command(Talk& talk, const Words& words) {
  const std::string which = words.empty() ? "" : words[0];
  std::vector<Listed> chosen;
  for (Listed& l : session::list(talk.document.session())) {
    const bool is_chosen = which.empty()       ? true
                           : which == "shapes" ? l.sort == Listed::Sort::shape
                           : which == "lights" ? l.sort == Listed::Sort::light
                           : which == "views"  ? l.sort == Listed::Sort::view
                                               : session::name_matches(which, l.name);
    if (is_chosen) chosen.push_back(std::move(l));
  }
  std::size_t name_width = 0, place_width = 0;
  for (const Listed& l : chosen) {
    name_width = std::max(name_width, l.name.size());
    place_width = std::max(place_width, l.place.size());
  }
  std::string out;
  for (const Listed& l : chosen) {
    out += fmt::format("{:<{}}  {:<6}  {:<{}}  {}:{}{}\n", l.name, name_width, l.kind, l.place, place_width,
                       l.file, l.line, l.look.empty() ? "" : "  " + l.look);
  }
  talk.tell(out.empty() ? "nothing\n" : out);
}

void show_command(Talk& talk, const Words& words) {
  const session::Outline outline = session::outline_of(talk.document.text());
  const std::vector<Listed> all = session::list(talk.document.session());
  if (const Item* item = find_any(outline, words[0]))
    return talk.tell(fmt::format("{}\n", text_of(talk.document.text(), *item)));
  const auto listed = find_listed(all, words[0]);
  if (!listed) nothing_is_named(outline, all, words[0]);
  talk.tell(fmt::format("{}  // {}:{}\n", talk.document.session().sources().text(listed->source),
                        listed->file, listed->line));
}

void delete_command(Talk& talk, const Words& words) {
  const std::string& text = talk.document.text();
  const session::Outline outline = session::outline_of(text);
  const std::vector<Listed> all = session::list(talk.document.session());
  if (const Item* item = find_any(outline, words[0]))
    return talk.answer(talk.document.change(without(text, *item), talk.run, label("delete", words)));
  const bool is_some = std::any_of(all.begin(), all.end(), [&](const Listed& l) {
    return l.is_named && session::name_matches(words[0], l.name);
  });
  if (is_some) {
    const std::string statement = fmt::format("remove {}", session::quoted_name(words[0]));
    return talk.answer(talk.document.enter(statement, talk.run));
  }
  const auto listed = find_listed(all, words[0]);
  if (!listed) nothing_is_named(outline, all, words[0]);
  const Item* item = item_at(outline, talk, *listed);
  if (item == nullptr) {
    throw UsageError(fmt::format("{} has no name of its own and is made at {}:{}; give it one there",
                                 words[0], listed->file, listed->line));
  }
  talk.answer(talk.document.change(without(text, *item), talk.run, label("delete", words)));
}

void rename_command(Talk& talk, const Words& words) {
  const std::string& text = talk.document.text();
  const session::Outline outline = session::outline_of(text);
  const std::vector<Listed> all = session::list(talk.document.session());
  const Item* item = find_item(outline, Item::Kind::object, words[0]);
  if (item == nullptr && find_any(outline, words[0]) != nullptr)
    throw UsageError(fmt::format("`{}` is no object; only those are renamed", words[0]));
  if (item == nullptr) {
    const auto listed = find_listed(all, words[0]);
    if (!listed) nothing_is_named(outline, all, words[0]);
    throw UsageError(fmt::format("\"{}\" is made at {}:{}, within a statement; change its name there",
                                 words[0], listed->file, listed->line));
  }
  if (find_listed(all, words[1])) throw UsageError(fmt::format("there is a \"{}\" already", words[1]));
  const std::string changed =
      text.substr(0, item->name_begin) + session::quoted_name(words[1]) + text.substr(item->name_end);
  talk.answer(talk.document.change(changed, talk.run, label("rename", words)));
}

}  // namespace lancer::app
