#include "app/repl/commands.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "app/option_values.hpp"
#include "base/diagnostic.hpp"
#include "session/vocabulary.hpp"

namespace lancer::app {
namespace {

constexpr std::size_t k_many = 100;

constexpr CommandInfo k_all[] = {
    {"list", "[shapes|lights|views|GLOB]", "what is in the scene, and where it is written", ":list bead*", 0,
     1, list_command},
    {"show", "NAME", "the source of a variable, function or object", ":show \"bead 1\"", 1, 1, show_command},
    {"delete", "NAME", "takes an object away, or a variable or function", ":delete \"bead 1\"", 1, 1,
     delete_command},
    {"rename", "OLD NEW", "gives an object another name", ":rename ball \"big ball\"", 2, 2, rename_command},
    {"undo", "[N]", "takes the last change back, or the last N", ":undo 2", 0, 1, undo_command},
    {"redo", "[N]", "makes changes again that were undone", ":redo", 0, 1, redo_command},
    {"history", "", "what was entered; `*` marks where the scene is", ":history", 0, 0, history_command},
    {"views", "", "the views, and which is the current one", ":views", 0, 0, views_command},
    {"view", "NAME", "makes a view the current one", ":view front", 1, 1, view_command},
    {"render", "[VIEW..] [FILE]", "draws the current view, or those named", ":render front ball.png", 0,
     k_many, render_command},
    {"plan", "", "what drawing the current view will take, and what is left out", ":plan", 0, 0,
     plan_command},
    {"stats", "", "what the last picture took", ":stats", 0, 0, stats_command},
    {"time", "EXPR", "how long an expression takes", ":time len(range(1000))", 1, 1, time_command, true},
    {"set", "[KEY VALUE]", "size W,H, samples N, error E or threads N of pictures; alone, what is set",
     ":set size 320,240", 0, 2, set_command},
    {"save", "[FILE]", "writes the scene as a script", ":save lamp.scn", 0, 1, save_command},
    {"open", "FILE", "begins anew with a script", ":open lamp.scn", 1, 1, open_command},
    {"reload", "", "reads the script again as it is on the disk", ":reload", 0, 0, reload_command},
    {"diff", "", "what has changed since the script was opened or saved", ":diff", 0, 0, diff_command},
    {"reset", "", "begins anew with nothing; :undo brings it back", ":reset", 0, 0, reset_command},
    {"help", "[WORD]", "what there is; or of a command, kind, attribute or function", ":help sphere", 0, 1,
     help_command},
    {"quit", "", "leaves", ":quit", 0, 0, quit_command},
};

const CommandInfo* find_command(std::string_view name) {
  const auto found =
      std::find_if(std::begin(k_all), std::end(k_all), [&](const CommandInfo& c) { return c.name == name; });
  return found == std::end(k_all) ? nullptr : found;
}

std::string usage(const CommandInfo& c) {
  return fmt::format(":{}{}{}", c.name, c.arguments.empty() ? "" : " ", c.arguments);
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& words) {
  const std::string_view near = nearest(word, words);
  return near.empty() ? "" : fmt::format("; did you mean {}?", near);
}

std::vector<std::string_view> command_words() {
  std::vector<std::string_view> out;
  for (const CommandInfo& c : k_all) out.push_back(c.name);
  return out;
}

}  // namespace

std::span<const CommandInfo> all_commands() { return k_all; }

Words split_words(std::string_view line) {
  Words out;
  bool is_within = false, is_quoted = false;
  for (const char c : line) {
    if (c == '"') {
      is_quoted = !is_quoted;
      if (is_quoted && !is_within) out.emplace_back();
      is_within = true;
    } else if (!is_quoted && (c == ' ' || c == '\t' || c == '\r')) {
      is_within = false;
    } else {
      if (!is_within) out.emplace_back();
      is_within = true;
      out.back() += c;
    }
  }
  if (is_quoted) throw UsageError("a quote is not closed");
  return out;
}

void run_command(Talk& talk, std::string_view line) {
  const std::string_view rest = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
  const std::string name(rest.substr(0, rest.find_first_of(" \t\r\"")));
  if (name.empty()) throw UsageError("a command follows the colon; :help lists them");
  const CommandInfo* command = find_command(name);
  if (command == nullptr) {
    const std::string_view near = nearest(name, command_words());
    throw UsageError(fmt::format("there is no command :{}; {}", name,
                                 near.empty() ? ":help lists them" : fmt::format("did you mean :{}?", near)));
  }
  const std::string_view behind = rest.substr(name.size());
  const std::size_t start = std::min(behind.find_first_not_of(" \t\r"), behind.size());
  Words words;
  if (!command->takes_text) {
    words = split_words(behind);
  } else if (start < behind.size()) {
    words.emplace_back(behind.substr(start));
  }
  if (words.size() < command->least || words.size() > command->most)
    throw UsageError(fmt::format("this is {}, such as {}", usage(*command), command->example));
  command->run(talk, words);
}

void help_command(Talk& talk, const Words& words) {
  if (words.empty()) {
    std::string out =
        "A statement changes the scene; an expression shows its value; a colon begins a command.\n\n";
    for (const CommandInfo& c : k_all) out += fmt::format("  {:<34}{}\n", usage(c), c.summary);
    out += fmt::format("\nkinds      {}\nfunctions  {}\n", fmt::join(session::kind_words(), " "),
                       fmt::join(session::function_words(), " "));
    return talk.tell(out);
  }
  std::string_view word = words[0];
  const bool is_command = word.starts_with(':');
  if (is_command) word.remove_prefix(1);
  std::string out;
  if (const CommandInfo* c = find_command(word))
    out += fmt::format("{}: {}\n  {}\n", usage(*c), c->summary, c->example);
  if (const auto text = session::describe(word); text && !is_command) out += *text;
  if (out.empty()) {
    std::vector<std::string_view> known = command_words();
    for (const std::string_view w : session::kind_words()) known.push_back(w);
    for (const std::string_view w : session::function_words()) known.push_back(w);
    throw UsageError(fmt::format("there is no help on `{}`{}", words[0], suggestion(word, known)));
  }
  talk.tell(out);
}

void quit_command(Talk& talk, const Words&) { talk.is_over = true; }

}  // namespace lancer::app
