#pragma once
// What may follow a colon: one table, from which commands are found, helped with and suggested.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/repl/talk.hpp"

namespace lancer::app {

using Words = std::vector<std::string>;

struct CommandInfo {
  std::string_view name;       // without its colon
  std::string_view arguments;  // "OLD NEW"
  std::string_view summary;
  std::string_view example;
  std::size_t least, most;  // words behind it
  /// Throws UsageError, with what is wrong in one line, or Refused where that was said.
  void (*run)(Talk& talk, const Words& words);
  bool takes_text = false;  // all that follows is one word, quotes and blanks included
};

std::span<const CommandInfo> all_commands();

/// Runs what stands behind a colon. Throws as commands do.
void run_command(Talk& talk, std::string_view line);

/// Words apart by blanks; quotes hold blanks together. Throws UsageError where one is not closed.
Words split_words(std::string_view line);

// command_scene.cpp
void list_command(Talk& talk, const Words& words);
void show_command(Talk& talk, const Words& words);
void delete_command(Talk& talk, const Words& words);
void rename_command(Talk& talk, const Words& words);
// command_history.cpp
void undo_command(Talk& talk, const Words& words);
void redo_command(Talk& talk, const Words& words);
void history_command(Talk& talk, const Words& words);
// command_picture.cpp
void views_command(Talk& talk, const Words& words);
void view_command(Talk& talk, const Words& words);
void render_command(Talk& talk, const Words& words);
void plan_command(Talk& talk, const Words& words);
void stats_command(Talk& talk, const Words& words);
void time_command(Talk& talk, const Words& words);
void set_command(Talk& talk, const Words& words);
// command_file.cpp
void save_command(Talk& talk, const Words& words);
void open_command(Talk& talk, const Words& words);
void reload_command(Talk& talk, const Words& words);
void diff_command(Talk& talk, const Words& words);
void reset_command(Talk& talk, const Words& words);
// commands.cpp
void help_command(Talk& talk, const Words& words);
void quit_command(Talk& talk, const Words& words);

}  // namespace lancer::app
