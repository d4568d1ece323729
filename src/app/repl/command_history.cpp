// :undo, :redo and :history.

#include <fmt/format.h>

#include "app/option_values.hpp"
#include "app/repl/commands.hpp"

namespace lancer::app {
namespace {

constexpr std::int64_t k_most_changes = 1'000'000;

std::size_t count_in(const char* command, const Words& words) {
  return words.empty() ? 1 : static_cast<std::size_t>(read_whole(command, words[0], 1, k_most_changes));
}

void say_moved(Talk& talk, const session::Reply& reply, std::size_t moved, const char* done) {
  talk.answer(reply);
  if (moved == 0) throw UsageError(fmt::format("there is nothing to {}", done));
  talk.tell(fmt::format("{} change{} {}ne\n", moved, moved == 1 ? "" : "s", done));
}

}  // namespace

void undo_command(Talk& talk, const Words& words) {
  session::Reply reply;
  const std::size_t moved = talk.document.undo(count_in(":undo", words), talk.run, reply);
  say_moved(talk, reply, moved, "undo");
}

void redo_command(Talk& talk, const Words& words) {
  session::Reply reply;
  const std::size_t moved = talk.document.redo(count_in(":redo", words), talk.run, reply);
  say_moved(talk, reply, moved, "redo");
}

void history_command(Talk& talk, const Words&) {
  const std::vector<std::string> all = talk.document.history();
  std::string out;
  for (std::size_t i = 0; i < all.size(); ++i)
    out += fmt::format("{} {:>3}  {}\n", i + 1 == talk.document.in_effect() ? '*' : ' ', i + 1, all[i]);
  talk.tell(out);
}

}  // namespace lancer::app
