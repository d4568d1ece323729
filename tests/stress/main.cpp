// lancer-stress: the tracer's geometry on the rays that are hardest for it, against the truth. The only file
// that includes CLI11, which is slow to compile.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <unistd.h>

#include "stress/report.hpp"
#include "stress/rows/rows.hpp"

namespace lancer::stress {
namespace {

enum ExitCode { fine = 0, limit_missed = 1, wrong_command_line = 2 };

struct Command {
  Settings settings;
  std::vector<std::string> patterns;
  bool list = false, json = false;
};

constexpr const char* k_footer =
    R"(Errors are in ulp of the true value (point and normal: of the worst component),
truth is MPFR's, with some 660 bits. `wrong` counts rays that were given a miss
for a hit, a hit for a miss or another surface; `in band` those of them that a
change of the input within 4 ulp would make right. `ns` is the time of a test;
> marks the method that Lancer uses, which the limits are for.

Exit codes: 0 every limit is met, 1 one is missed, 2 the command line is wrong.)";

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

/// The rows that the patterns name, in their own order.
Rows chosen(const std::vector<std::string>& patterns) {
  Rows rows = all_rows();
  if (patterns.empty()) return rows;
  for (const std::string& pattern : patterns) {
    if (std::ranges::none_of(rows, [&](const Row& row) { return matches(pattern, row.name); })) {
      throw CLI::ValidationError("--row",
                                 fmt::format("no row is named `{}`; --list tells the names", pattern));
    }
  }
  std::erase_if(rows, [&](const Row& row) {
    return std::ranges::none_of(patterns, [&](const std::string& p) { return matches(p, row.name); });
  });
  return rows;
}

Report run(const Row& row, const Settings& settings) {
  Report report{row.name, row.about, {}, 0, {}};
  const auto start = std::chrono::steady_clock::now();
  try {
    report.outcome = row.run(settings);
    if (report.outcome.limits.empty()) report.failure = "a row without a limit";
  } catch (const std::exception& error) {
    report.failure = error.what();
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

void list(const Rows& rows) {
  std::size_t width = 0;
  for (const Row& row : rows) width = std::max(width, row.name.size());
  for (const Row& row : rows) print(fmt::format("{:<{}}  {}\n", row.name, width, row.about));
}

ExitCode run(const Rows& rows, const Command& command) {
  const char* const no_color = std::getenv("NO_COLOR");
  const bool colored = isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == 0);
  std::vector<Report> reports;
  for (const Row& row : rows) {
    reports.push_back(run(row, command.settings));
    if (!command.json) print(as_table(reports.back(), colored) + '\n');
  }
  print(command.json ? as_json(reports, command.settings) : summary(reports, colored));
  return std::ranges::all_of(reports, [](const Report& r) { return r.met(); }) ? fine : limit_missed;
}

ExitCode run(int argc, char** argv) {
  CLI::App app("Traces the rays that are hardest for Lancer's geometry and compares with the truth.",
               "lancer-stress");
  app.footer(k_footer);
  Command command;
  app.add_flag("--long", command.settings.full, "The full counts of rays, which take up to an hour");
  app.add_flag("--json", command.json, "One JSON object in place of the table");
  app.add_flag("--list", command.list, "Only tell the names of the rows");
  app.add_option("--row", command.patterns, "Only the rows of this name, with * and ?; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--seed", command.settings.seed, "Of the random parts (1)")->type_name("N");
  try {
    app.parse(argc, argv);
    const Rows rows = chosen(command.patterns);
    if (!command.list) return run(rows, command);
    list(rows);
    return fine;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? fine : wrong_command_line;
  }
}

}  // namespace
}  // namespace lancer::stress

int main(int argc, char** argv) { return lancer::stress::run(argc, argv); }
