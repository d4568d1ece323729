#include "app/plan_command.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/find_view.hpp"
#include "app/json.hpp"
#include "app/option_values.hpp"
#include "app/report.hpp"

namespace lancer::app {
namespace {

constexpr std::array<const char*, 4> k_verdicts{"skipped", "as met", "needed", "off"};  // as tracer::Verdict
constexpr std::array<const char*, 3> k_shadows{"none", "blocked", "filtered"};  // as tracer::ShadowWork

/// How many of each kind.
template <class T, std::size_t N>
PlanReport::Counts counted(const std::vector<T>& all, const std::array<const char*, N>& kinds) {
  std::array<std::uint64_t, N> counts{};
  for (const T& one : all) ++counts[static_cast<std::size_t>(one.kind)];
  PlanReport::Counts out;
  for (std::size_t i = 0; i < N; ++i) {
    if (counts[i] > 0) out.emplace_back(kinds[i], counts[i]);
  }
  return out;
}

/// That are shot at the least.
std::uint64_t primary_rays(const tracer::Options& options, int width, int height) {
  const tracer::Region r = options.region.value_or(tracer::Region{0, 0, width, height});
  const auto side = [](int from, int to, int end) {
    return static_cast<std::uint64_t>(std::max(0, std::min(to, end) - std::min(from, end)));
  };
  const std::uint64_t columns = side(r.x0, r.x1, width), rows = side(r.y0, r.y1, height);
  return options.samples > 0 ? columns * rows * static_cast<std::uint64_t>(options.samples)
                             : tracer::least_samples(columns, rows);
}

std::string listed(const PlanReport::Counts& counts) {
  std::string out;
  for (const auto& [kind, count] : counts) {
    const std::string plural = kind == "box" || kind == "mesh" ? kind + "es" : kind + "s";
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, count == 1 ? kind : plural);
  }
  return out.empty() ? "none" : out;
}

std::string onward_text(const PlanReport& report) {
  if (report.depth == 0) return "none";
  const char* what = report.reflects && report.transmits ? "reflected and refracted"
                     : report.reflects                   ? "reflected"
                                                         : "refracted";
  return fmt::format("{}, to depth {}", what, report.depth);
}

std::string shadow_text(const PlanReport& report) {
  if (report.shadows == "none") return "none";
  return report.shadows == "blocked" ? "is anything in the way?" : "what comes through everything in the way";
}

/// The skips of a verdict under a heading; nothing where there are none.
std::string section(const PlanReport& report, const char* heading, std::string_view verdict) {
  std::string out;
  for (const PlanReport::Line& line : report.skips) {
    if (line.verdict != verdict) continue;
    out += fmt::format("  {:<13}{}", line.name, line.what);
    if (!line.why.empty()) out += verdict == "as met" ? fmt::format(" ({})", line.why) : ", as " + line.why;
    out += "\n";
  }
  return out.empty() ? out : fmt::format("\n{}\n{}", heading, out);
}

/// Runs the script and reports; the exit code.
int run(const PlanCommand& command, const Console& console) {
  DiskHost host({}, console.interrupt);
  session::Session session(host);
  session::RunOptions options = command.run;
  options.interrupt = &console.interrupt;
  const session::Run run = run_script(session, host, command.file, options);
  report_mistakes(session, run, console);
  if (run.outcome != session::Outcome::fine) return exit_code_of(run.outcome);
  const std::size_t view = command.view ? find_view(session, *command.view) : 0;
  const PlanReport made = plan_report(session, view, command.file, command.options);
  console.out.write(command.json ? to_json(made) : to_text(made));
  console.out.flush();
  return k_fine;
}

}  // namespace

PlanReport plan_report(const session::Session& session, std::size_t view_index, std::string file,
                       const tracer::Options& options) {
  const scene::Scene& scene = session.scene();
  const scene::View view = session.views()[view_index];
  const tracer::Plan plan = session.plan(view, options);
  PlanReport out;
  out.file = std::move(file);
  out.view = session.view_name(view_index);
  for (std::size_t i = 0; i < session.views().size(); ++i) {
    if (i != view_index) out.other_views.push_back(session.view_name(i));
  }
  out.width = options.columns.value_or(view.columns);
  out.height = options.rows.value_or(view.rows);
  out.samples = options.samples;
  out.error = options.error;
  out.primary_rays = primary_rays(options, out.width, out.height);
  out.depth = plan.reflects || plan.transmits ? scene.settings.depth : 0;
  out.reflects = plan.reflects || (plan.transmits && plan.media);  // totally, where indices differ
  out.transmits = plan.transmits;
  out.shadows = k_shadows[static_cast<std::size_t>(plan.shadows)];
  out.structure = plan.tree ? "tree" : "list";
  out.things = plan.primitives;
  out.materials = plan.worn;
  out.shapes = counted(scene.shapes, std::array{"sphere", "plane", "box", "facet", "mesh"});
  out.lights = counted(scene.lights, std::array{"light", "sun", "spot"});
  for (const tracer::Decision& decision : plan.decisions) {
    out.skips.push_back({std::string(tracer::name_of(decision.skip)),
                         k_verdicts[static_cast<std::size_t>(decision.verdict)],
                         std::string(tracer::what_of(decision.skip)), tracer::in_words(scene, decision)});
  }
  return out;
}

std::string to_text(const PlanReport& r) {
  std::string out = fmt::format("view `{}` of {}: {} x {} pixels, {}\n\n", r.view, r.file, r.width, r.height,
                                r.samples > 0 ? fmt::format("{} samples each", r.samples)
                                              : fmt::format("each to an error of {}", r.error));
  const auto line = [&](const char* name, const std::string& text) {
    out += fmt::format("  {:<13}{}\n", name, text);
  };
  line("shapes", listed(r.shapes));
  line("materials", fmt::format("{} worn", r.materials));
  line("lights", listed(r.lights));
  if (!r.other_views.empty())
    line("other views", fmt::format("`{}`: not drawn", fmt::join(r.other_views, "`, `")));
  line("structure", fmt::format("a {} of {}", r.structure, r.things));
  line("primary",
       r.samples > 0 ? fmt::format("{} rays", r.primary_rays)
                     : fmt::format("{} rays for a first look, and more in the pixels that it leaves in doubt",
                                   r.primary_rays));
  line("onward rays", onward_text(r));
  line("shadow rays", shadow_text(r));
  out += section(r, "left out", "skipped");
  out += section(r, "left out where met", "as met");
  out += section(r, "needed", "needed");
  out += section(r, "not needed, and done all the same for --no-skip", "off");
  return out;
}

int plan(const PlanCommand& command, const Console& console) {
  try {
    return run(command, console);
  } catch (const UsageError& problem) {
    complain(problem.what());
    return k_command_wrong;
  }
}

}  // namespace lancer::app
