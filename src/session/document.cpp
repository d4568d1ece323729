#include "session/document.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <utility>

#include "lang/glob.hpp"
#include "session/outline.hpp"

namespace lancer::session {
namespace {

/// Keeps what a script prints.
class Listener : public Host {
 public:
  explicit Listener(Host& host) : host_(host) {}
  FileText read(const std::string& canonical) override { return host_.read(canonical); }
  std::string canonical(const std::string& path) override { return host_.canonical(path); }
  void print(std::string_view text) override { printed += text; }

  std::string printed;

 private:
  Host& host_;
};

/// The lines that are not the same as before: those behind the first that differs.
std::string news(const std::string& before, const std::string& now) {
  std::size_t same = 0;
  for (std::size_t i = 0; i < std::min(before.size(), now.size()) && before[i] == now[i]; ++i) {
    if (now[i] == '\n') same = i + 1;
  }
  return now.substr(same);
}

bool is_an_expression(const Outline& entry) {
  return !entry.is_wrong && entry.items.size() == 1 &&
         (entry.items[0].kind == Item::Kind::expression || entry.items[0].kind == Item::Kind::object);
}

/// Whether the only thing wrong is that the statement's value adds nothing.
bool is_a_mere_value(const Run& run) {
  std::size_t errors = 0, values = 0;
  for (const Diagnostic& d : run.diagnostics) {
    errors += d.severity == Severity::error ? 1 : 0;
    values += d.code == Code::not_an_object && d.trace.empty() ? 1 : 0;
  }
  return errors == 1 && values == 1;
}

bool has_name(const scene::Scene& scene, const std::string& name) {
  return std::find(scene.names.begin() + 1, scene.names.end(), name) != scene.names.end();
}

/// What an item of an entry takes the place of; null where it is new.
const Item* find_given(const Outline& outline, const Item& item) {
  if (item.kind == Item::Kind::object) return find_item(outline, Item::Kind::object, item.name);
  if (item.kind != Item::Kind::variable && item.kind != Item::Kind::function) return nullptr;
  const Item* variable = find_item(outline, Item::Kind::variable, item.name);
  return variable != nullptr ? variable : find_item(outline, Item::Kind::function, item.name);
}

std::string first_line(std::string_view text) { return std::string(text.substr(0, text.find('\n'))); }

}  // namespace

struct Document::Tried {
  Run run;                            // without the warnings that were given before
  std::vector<std::string> warnings;  // all
  std::shared_ptr<Listener> host;
  std::shared_ptr<Session> session;
};

Document::Document(Host& host) : host_(host), states_{std::make_shared<const std::string>()}, labels_{""} {
  Tried empty = run("", {});
  accept(empty);
}

Document::Tried Document::run(const std::string& text, const RunOptions& options) const {
  Tried out;
  out.host = std::make_shared<Listener>(host_);
  out.session = std::make_shared<Session>(*out.host);
  RunOptions all = options;
  all.keep_unused = true;
  out.run = out.session->run_text(name_, text, std::filesystem::path(name_).parent_path().string(), all);
  std::vector<std::string> known = warnings_;
  std::erase_if(out.run.diagnostics, [&](const Diagnostic& d) {
    if (d.severity != Severity::warning) return false;
    out.warnings.push_back(d.message);
    const auto found = std::find(known.begin(), known.end(), d.message);
    if (found == known.end()) return false;
    known.erase(found);
    return true;
  });
  return out;
}

/// The scene is the one that was tried.
void Document::accept(Tried& tried) {
  printed_ = tried.host->printed;
  warnings_ = std::move(tried.warnings);
  session_ = tried.session;
  session_host_ = tried.host;
}

/// Makes it the newest state where it ran well; states that were undone are gone then.
Reply Document::settle(Tried tried, std::string text, std::string label) {
  Reply out{std::move(tried.run), {}, false, false, tried.session};
  if (out.run.outcome != Outcome::fine) {
    out.printed = news(printed_, tried.host->printed);
    return out;
  }
  out.is_changed = true;
  out.printed = news(printed_, tried.host->printed);
  accept(tried);
  states_.resize(current_ + 1);
  labels_.resize(current_ + 1);
  states_.push_back(std::make_shared<const std::string>(std::move(text)));
  labels_.push_back(std::move(label));
  ++current_;
  return out;
}

/// The text with each statement of the entry at its place.
std::string Document::with_statements(std::string_view entry) const {
  std::string out = text();
  std::string rest;       // of the entry, for the end of the text
  std::size_t taken = 0;  // of the entry
  for (const Item& item : outline_of(entry).items) {
    rest += entry.substr(taken, item.begin - taken);
    taken = item.end;
    const Outline outline = outline_of(out);
    if (const Item* old = find_given(outline, item)) {
      out = replaced(out, *old, text_of(entry, item));
      continue;
    }
    const bool is_elsewhere = item.kind == Item::Kind::object && !item.name.empty() &&
                              !lang::is_glob(item.name) && has_name(session_->scene(), item.name);
    if (is_elsewhere) rest += fmt::format("remove {}\n", quoted_name(item.name));
    rest += text_of(entry, item);
  }
  rest += entry.substr(taken);
  const std::size_t start = rest.find_first_not_of(" \t\r\n;");
  return start == std::string::npos ? out : appended(out, std::string_view(rest).substr(start));
}

Reply Document::enter(std::string_view entry, const RunOptions& options) {
  const Outline outline = outline_of(entry);
  if (outline.is_incomplete) {
    Tried tried = run(appended(text(), entry), options);
    return {std::move(tried.run), {}, true, false, tried.session};
  }
  const std::string plain = appended(text(), entry);
  if (outline.is_wrong) {
    Tried tried = run(plain, options);
    return {std::move(tried.run), {}, false, false, tried.session};
  }
  std::string changed = with_statements(entry);
  Tried tried = run(changed, options);
  if (is_an_expression(outline) && is_a_mere_value(tried.run)) {
    Tried shown = run(appended(text(), fmt::format("print({})", text_of(entry, outline.items[0]))), options);
    return {std::move(shown.run), news(printed_, shown.host->printed), false, false, shown.session};
  }
  return settle(std::move(tried), std::move(changed), first_line(entry));
}

Reply Document::change(std::string text, const RunOptions& options, std::string label) {
  Tried tried = run(text, options);
  return settle(std::move(tried), std::move(text), std::move(label));
}

Reply Document::open(const std::string& path, std::string text, const RunOptions& options) {
  const std::string old = std::exchange(name_, path);
  warnings_.clear();
  Tried tried = run(text, options);
  if (tried.run.outcome != Outcome::fine) {
    name_ = old;
    return {std::move(tried.run), tried.host->printed, false, false, tried.session};
  }
  states_ = {std::make_shared<const std::string>(std::move(text))};
  labels_ = {""};
  current_ = 0;
  accept(tried);
  return {std::move(tried.run), printed_, false, true, session_};
}

std::size_t Document::move_to(std::size_t state, const RunOptions& options, Reply& reply) {
  Tried tried = run(*states_[state], options);
  reply.run = std::move(tried.run);
  reply.session = tried.session;
  if (reply.run.outcome != Outcome::fine) return 0;
  const std::size_t moved = state > current_ ? state - current_ : current_ - state;
  current_ = state;
  accept(tried);
  reply.is_changed = moved > 0;
  return moved;
}

std::size_t Document::undo(std::size_t count, const RunOptions& options, Reply& reply) {
  return move_to(current_ - std::min(count, current_), options, reply);
}

std::size_t Document::redo(std::size_t count, const RunOptions& options, Reply& reply) {
  return move_to(current_ + std::min(count, states_.size() - 1 - current_), options, reply);
}

std::vector<std::string> Document::history() const { return {labels_.begin() + 1, labels_.end()}; }

}  // namespace lancer::session
