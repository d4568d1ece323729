// The only file that includes CLI11, which is slow to compile.

#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <unistd.h>

#include "app/exit_code.hpp"
#include "app/general_help.hpp"
#include "app/option_values.hpp"
#include "base/diagnostic.hpp"

namespace lancer::app {
namespace {

constexpr std::int64_t k_most = std::numeric_limits<std::int64_t>::max();
constexpr double k_usual_error = 0.05;  // docs/performance.md tells why
constexpr std::int64_t k_most_samples = 1 << 20;
constexpr std::int64_t k_most_threads = 1024;
constexpr std::array<std::string_view, 5> k_commands{"render", "check", "dump", "plan", "repl"};

/// As typed; read strictly afterwards.
struct ScriptTexts {
  std::vector<std::string> folders, defines;
  std::string max_steps, max_objects;
};

/// What becomes tracer::Options, the same for every command that draws or plans to.
struct PictureTexts {
  std::string size, error, samples, region, no_skip;
};

struct RenderTexts {
  ScriptTexts script;
  PictureTexts picture;
  std::string output, threads, format, stats;
};

/// An option that may be repeated, with one value each time.
void add_repeated(CLI::App& app, const std::string& names, std::vector<std::string>& target,
                  const std::string& value, const std::string& what) {
  app.add_option(names, target, what)->type_name(value)->allow_extra_args(false);
}

CLI::Option* add_text(CLI::App& app, const std::string& names, std::string& target, const std::string& value,
                      const std::string& what) {
  return app.add_option(names, target, what)->type_name(value);
}

void add_script_options(CLI::App& app, ScriptTexts& texts) {
  add_repeated(app, "-D,--define", texts.defines, "NAME=VALUE", "Set a variable of the script from outside");
  add_repeated(app, "-I,--include", texts.folders, "DIR", "Look for included files here too");
  add_text(app, "--max-steps", texts.max_steps, "N",
           "Stop a script after so many steps (100000000; 0: never)");
  add_text(app, "--max-objects", texts.max_objects, "N", "Allow so many objects (10000000; 0: any number)");
}

void add_picture_options(CLI::App& app, PictureTexts& texts) {
  add_text(app, "--size", texts.size, "W,H", "The picture's size in pixels, in place of the view's");
  add_text(app, "--error", texts.error, "E",
           fmt::format("As many rays in each pixel as keep it this near to the truth, as shown ({})",
                       k_usual_error));
  add_text(app, "--samples", texts.samples, "N",
           "So many rays in every pixel, in place of an error; 1 is the pixel's centre");
  add_text(app, "--region", texts.region, "X0,Y0,X1,Y1", "Only these pixels; X1 and Y1 are excluded");
  app.add_flag(
      "--no-skip", texts.no_skip,
      "Do what the picture does not need, too; --no-skip=NAME,NAME: only what `lancer plan` calls so");
}

void add_render(CLI::App& app, RenderCommand& command, RenderTexts& texts) {
  app.add_option("FILE", command.file, "The script; - reads standard input")->required()->type_name("");
  add_text(app, "-o,--output", texts.output, "OUT",
           "The picture, by its ending .png, .ppm, .pfm or .exr; - writes standard output");
  add_text(app, "--format", texts.format, "F",
           fmt::format("Its format, whatever the ending: {}", image::k_format_names));
  add_repeated(app, "--view", command.views, "NAME", "Draw this view; may be repeated");
  app.add_flag("--all-views", command.all_views, "Draw every view");
  add_picture_options(app, texts.picture);
  add_text(app, "--threads", texts.threads, "N", "Threads to draw with (0: as many as the machine has)");
  add_script_options(app, texts.script);
  app.add_flag("--stats", texts.stats, "Tell what the drawing took; --stats=json on standard output");
  app.add_flag("--quiet", command.quiet, "Say nothing but errors and warnings");
}

void read_script_options(const ScriptTexts& texts, session::RunOptions& run) {
  run.include_folders = texts.folders;
  for (const std::string& text : texts.defines) run.defines.push_back(read_define(text));
  if (!texts.max_steps.empty()) {
    run.limits.steps = static_cast<std::uint64_t>(read_whole("--max-steps", texts.max_steps, 0, k_most));
  }
  if (!texts.max_objects.empty()) {
    run.limits.objects =
        static_cast<std::uint64_t>(read_whole("--max-objects", texts.max_objects, 0, k_most));
  }
}

void read_picture_options(const PictureTexts& texts, tracer::Options& options) {
  if (!texts.size.empty()) read_size(texts.size, options);
  if (!texts.region.empty()) options.region = read_region(texts.region);
  if (!texts.error.empty() && !texts.samples.empty())
    throw UsageError("--error and --samples exclude each other");
  if (texts.samples.empty()) {
    options.error = texts.error.empty() ? k_usual_error : read_error(texts.error);
    options.samples = 0;
  } else {
    options.samples = static_cast<int>(read_whole("--samples", texts.samples, 1, k_most_samples));
  }
  if (!texts.no_skip.empty()) options.skips = read_skips(texts.no_skip);
}

void read_render_options(const RenderTexts& texts, RenderCommand& command) {
  read_script_options(texts.script, command.run);
  if (command.all_views && !command.views.empty())
    throw UsageError("--view and --all-views exclude each other");
  if (!texts.output.empty()) command.output = texts.output;
  read_picture_options(texts.picture, command.options);
  if (!texts.threads.empty()) {
    command.options.threads = static_cast<int>(read_whole("--threads", texts.threads, 0, k_most_threads));
  }
  if (!texts.format.empty()) {
    command.format = image::format_from_name(texts.format);
    if (!command.format) {
      throw UsageError(
          fmt::format("--format is one of {}; this is `{}`", image::k_format_names, texts.format));
    }
  }
  if (texts.stats == "text" || texts.stats == "true") command.stats = StatsFormat::text;  // "true": no value
  if (texts.stats == "json") command.stats = StatsFormat::json;
  if (!texts.stats.empty() && command.stats == StatsFormat::none) {
    throw UsageError(fmt::format("--stats is --stats or --stats=json; this is `--stats={}`", texts.stats));
  }
}

/// What the parser did not expect, with the option that was probably meant.
std::string unexpected(CLI::App& app, const std::string& argument) {
  if (argument.size() < 2 || argument[0] != '-') return fmt::format("`{}` is one file too many", argument);
  const std::string word = argument.substr(0, argument.find('='));
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string_view near = nearest(word, std::vector<std::string_view>(names.begin(), names.end()));
  return fmt::format("there is no option {}{}", word,
                     near.empty() ? "" : fmt::format("; did you mean {}?", near));
}

Answer wrong(const std::string& what) {
  return {k_command_wrong, fmt::format("lancer: {}\nlancer --help shows what there is\n", what)};
}

/// Parses for one command; nothing when that went well.
std::optional<Answer> parse(CLI::App& app, std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());
  try {
    app.parse(std::move(arguments));
    for (const CLI::Option* option : app.get_options()) {
      const std::vector<std::string> values = option->results();
      const bool has_empty = std::find(values.begin(), values.end(), "") != values.end();
      if (has_empty && option != app["FILE"]) return wrong(option->get_name() + " takes a value");
    }
  } catch (const CLI::CallForHelp&) {
    return Answer{k_fine, app.help()};
  } catch (const CLI::ArgumentMismatch& problem) {
    const std::string what = problem.what();
    const bool is_repeated = what.find("At Most") != std::string::npos;
    return wrong(what.substr(0, what.find(':')) + (is_repeated ? " is given twice" : " takes a value"));
  } catch (const CLI::ParseError& problem) {
    const std::vector<std::string> unknown = app.remaining();
    if (!unknown.empty()) return wrong(unexpected(app, unknown.front()));
    return wrong(app["FILE"]->empty() ? "there is no FILE to work on" : problem.what());
  }
  return std::nullopt;
}

Command parse_render(std::vector<std::string> arguments) {
  CLI::App app("Draw a script's views", "lancer render");
  app.footer(k_examples);
  RenderCommand command;
  RenderTexts texts;
  add_render(app, command, texts);
  if (auto answer = parse(app, std::move(arguments))) return *answer;
  read_render_options(texts, command);
  return command;
}

Command parse_check(std::vector<std::string> arguments) {
  CLI::App app("Find mistakes in scripts without drawing", "lancer check");
  CheckCommand command;
  ScriptTexts texts;
  std::string format = "text";
  app.add_option("FILE", command.files, "The scripts; - reads standard input")->required()->type_name("");
  app.add_flag("--run", command.prints, "Show what the scripts print");
  app.add_option("--format", format, "How messages are written: text or json, one object a line")
      ->type_name("text|json");
  add_script_options(app, texts);
  if (auto answer = parse(app, std::move(arguments))) return *answer;
  read_script_options(texts, command.run);
  if (format != "text" && format != "json")
    throw UsageError(fmt::format("--format is text or json; this is `{}`", format));
  command.json = format == "json";
  return command;
}

Command parse_dump(std::vector<std::string> arguments) {
  CLI::App app("Show what Lancer makes of a script", "lancer dump");
  DumpCommand command;
  ScriptTexts texts;
  bool scene = false;
  app.add_option("FILE", command.file, "The script; - reads standard input")->required()->type_name("");
  app.add_flag("--ast", command.ast, "The script as it was understood");
  app.add_flag("--scene", scene, "The scene that it makes");
  add_script_options(app, texts);
  if (auto answer = parse(app, std::move(arguments))) return *answer;
  read_script_options(texts, command.run);
  if (command.ast == scene) throw UsageError("dump takes either --ast or --scene");
  return command;
}

Command parse_plan(std::vector<std::string> arguments) {
  CLI::App app("Tell what a render does, what it leaves out, and why", "lancer plan");
  PlanCommand command;
  ScriptTexts script;
  PictureTexts picture;
  std::string view;
  app.add_option("FILE", command.file, "The script; - reads standard input")->required()->type_name("");
  add_text(app, "--view", view, "NAME", "Of this view; else of the first");
  add_picture_options(app, picture);
  add_script_options(app, script);
  app.add_flag("--json", command.json, "As one JSON object");
  if (auto answer = parse(app, std::move(arguments))) return *answer;
  read_script_options(script, command.run);
  read_picture_options(picture, command.options);
  if (!view.empty()) command.view = view;
  return command;
}

Command parse_repl(std::vector<std::string> arguments) {
  CLI::App app("Build a scene by talking to it", "lancer repl");
  ReplCommand command;
  ScriptTexts script;
  PictureTexts picture;
  app.add_option("FILE", command.file, "A script to begin with")->type_name("");
  app.add_flag("--keep-going", command.keep_going, "Go on after an error where input is no terminal");
  add_picture_options(app, picture);
  add_script_options(app, script);
  if (auto answer = parse(app, std::move(arguments))) return *answer;
  read_script_options(script, command.run);
  read_picture_options(picture, command.options);
  return command;
}

bool is_command(const std::string& word) {
  return std::find(k_commands.begin(), k_commands.end(), word) != k_commands.end();
}

/// A command with a slip in it rather than the name of a script.
std::optional<Answer> misspelt_command(const std::string& word) {
  if (is_command(word) || word.empty() || word[0] == '-' || word.find_first_of("./") != std::string::npos)
    return std::nullopt;
  const std::string_view near =
      nearest(word, std::vector<std::string_view>(k_commands.begin(), k_commands.end()));
  std::error_code ignored;
  if (near.empty() || std::filesystem::exists(word, ignored)) return std::nullopt;
  return wrong(fmt::format("there is no command {}; did you mean {}?", word, near));
}

}  // namespace

Command parse_command_line(std::vector<std::string> arguments) {
  if (arguments.empty() && isatty(STDIN_FILENO) == 1) return parse_repl({});
  if (arguments.empty()) return Answer{k_command_wrong, general_help()};
  const std::string first = arguments.front();
  if (first == "--help" || first == "-h" || first == "help") return Answer{k_fine, general_help()};
  if (first == "--version") return Answer{k_fine, "lancer " LANCER_VERSION "\n"};
  if (auto answer = misspelt_command(first)) return *answer;
  if (is_command(first)) arguments.erase(arguments.begin());
  try {
    if (first == "check") return parse_check(std::move(arguments));
    if (first == "dump") return parse_dump(std::move(arguments));
    if (first == "plan") return parse_plan(std::move(arguments));
    if (first == "repl") return parse_repl(std::move(arguments));
    return parse_render(std::move(arguments));
  } catch (const UsageError& problem) {
    return wrong(problem.what());
  }
}

}  // namespace lancer::app
