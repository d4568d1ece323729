#pragma once
// What the user asks for.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "image/format.hpp"
#include "session/session.hpp"
#include "tracer/options.hpp"

namespace lancer::app {

enum class StatsFormat { none, text, json };

struct RenderCommand {
  std::string file;  // "-": standard input
  std::optional<std::string> output;
  std::optional<image::Format> format;
  std::vector<std::string> views;
  bool all_views = false;
  tracer::Options options;
  StatsFormat stats = StatsFormat::none;
  bool quiet = false;
  session::RunOptions run;
};

struct CheckCommand {
  std::vector<std::string> files;
  bool prints = false;  // what the scripts print is let through
  bool json = false;
  session::RunOptions run;
};

struct DumpCommand {
  std::string file;
  bool ast = false;  // else the scene
  session::RunOptions run;
};

struct PlanCommand {
  std::string file;
  std::optional<std::string> view;  // else the first
  tracer::Options options;
  bool json = false;
  session::RunOptions run;
};

struct ReplCommand {
  std::string file;         // empty: none
  bool keep_going = false;  // after an error, where input is no terminal
  tracer::Options options;
  session::RunOptions run;
};

/// Nothing to do but to say something: help, the version, or what is wrong with the command line.
struct Answer {
  int exit_code;
  std::string text;
};

using Command = std::variant<RenderCommand, CheckCommand, DumpCommand, PlanCommand, ReplCommand, Answer>;

/// `arguments` without the program's own name. `lancer FILE` is `lancer render FILE`.
Command parse_command_line(std::vector<std::string> arguments);

}  // namespace lancer::app
