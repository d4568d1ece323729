#include "app/render_command.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/find_view.hpp"
#include "app/json.hpp"
#include "app/option_values.hpp"
#include "app/output_path.hpp"
#include "app/progress.hpp"
#include "app/report.hpp"
#include "image/encode.hpp"
#include "image/file.hpp"

namespace lancer::app {
namespace {

/// A view to draw, and where to.
struct Target {
  scene::View view;
  std::string name;
  std::string path;  // "-": standard output
};

/// Ends the command with this exit code; why has been said.
struct Ended {
  int exit_code;
};

class Renderer {
 public:
  Renderer(const RenderCommand& command, const Console& console);

  void run();

 private:
  bool to_stream() const { return path_ == k_stream; }
  void run_script_first();
  std::vector<std::size_t> chosen_views() const;
  std::vector<Target> targets() const;
  void check_target(const Target& target) const;
  void note_other_views(const Target& drawn) const;
  void draw(const Target& target);
  void write(const Target& target, const image::Image& picture);
  void tell(const Target& target, const tracer::Rendered& rendered, double seconds);

  const RenderCommand& command_;
  const Console& console_;
  std::string path_;  // as asked for, views not told apart
  image::Format format_;
  DiskHost host_;
  session::Session session_;
  std::uint64_t steps_ = 0;
};

image::Format format_for(const RenderCommand& command) {
  if (command.format) return *command.format;
  if (!command.output || command.output == k_stream) return image::Format::png8;
  if (const auto format = image::format_from_path(*command.output)) return *format;
  const std::string ending = std::filesystem::path(*command.output).extension().string();
  if (ending.empty()) return image::Format::png8;
  throw UsageError(
      fmt::format("there is no picture format for {}; the endings are {}, or name one with --format", ending,
                  image::k_format_endings));
}

std::string path_for(const RenderCommand& command, image::Format format) {
  if (command.output) return *command.output;
  return command.file == k_stream ? k_stream : beside_script(command.file, format);
}

Renderer::Renderer(const RenderCommand& command, const Console& console)
    : command_(command),
      console_(console),
      path_(path_for(command, format_for(command))),
      format_(format_for(command)),
      host_([this](std::string_view text) { to_stream() ? say(text) : console_.out.write(text); },
            console.interrupt),
      session_(host_) {
  if (to_stream() && console.out.is_terminal()) {
    throw UsageError("a picture is not for a terminal; name a file with -o, or send it on with > or |");
  }
}

void Renderer::run() {
  run_script_first();
  const std::vector<Target> all = targets();
  for (const Target& target : all) check_target(target);
  for (const Target& target : all) draw(target);
  if (all.size() == 1) note_other_views(all.front());
  console_.out.flush();
}

void Renderer::run_script_first() {
  session::RunOptions options = command_.run;
  options.interrupt = &console_.interrupt;
  const session::Run run = run_script(session_, host_, command_.file, options);
  console_.out.flush();
  report_mistakes(session_, run, console_);
  if (run.outcome != session::Outcome::fine) throw Ended{exit_code_of(run.outcome)};
  steps_ = run.steps;
}

std::vector<std::size_t> Renderer::chosen_views() const {
  std::vector<std::size_t> out;
  const std::size_t count = session_.views().size();
  for (std::size_t i = 0; command_.all_views && i < count; ++i) out.push_back(i);
  for (const std::string& name : command_.views) {
    const std::size_t i = find_view(session_, name);
    if (std::find(out.begin(), out.end(), i) == out.end()) out.push_back(i);
  }
  if (out.empty()) out.push_back(0);
  return out;
}

std::vector<Target> Renderer::targets() const {
  const std::vector<scene::View> views = session_.views();
  const std::vector<std::size_t> chosen = chosen_views();
  std::vector<std::string> names;
  for (const std::size_t i : chosen) names.push_back(session_.view_name(i));
  if (to_stream() && chosen.size() > 1) {
    throw UsageError("standard output takes one picture; name one view with --view, or a file with -o");
  }
  const bool is_one = to_stream() || (chosen.size() == 1 && !command_.all_views);
  const std::vector<std::string> paths = is_one ? std::vector{path_} : paths_of_views(path_, names);
  std::vector<Target> out;
  for (std::size_t i = 0; i < chosen.size(); ++i) out.push_back({views[chosen[i]], names[i], paths[i]});
  return out;
}

/// What would go wrong after the work is better said before.
void Renderer::check_target(const Target& target) const {
  const tracer::Options& options = command_.options;
  const int columns = options.columns.value_or(target.view.columns),
            rows = options.rows.value_or(target.view.rows);
  if (options.region && (options.region->x1 > columns || options.region->y1 > rows)) {
    throw UsageError(fmt::format(
        "the region {},{},{},{} reaches out of the picture, which has {} x {} pixels", options.region->x0,
        options.region->y0, options.region->x1, options.region->y1, columns, rows));
  }
  if (target.path == k_stream) return;
  std::error_code ignored;
  if (command_.file != k_stream && std::filesystem::equivalent(target.path, command_.file, ignored)) {
    throw UsageError(fmt::format("{} is the script itself; name another file with -o", target.path));
  }
  if (const auto problem = image::can_write(target.path)) {
    complain(*problem);
    throw Ended{k_file_trouble};
  }
}

void Renderer::note_other_views(const Target& drawn) const {
  const std::size_t count = session_.views().size();
  if (command_.quiet || count == 1 || !command_.views.empty()) return;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(session_.view_name(i));
  say(fmt::format("note: this is view `{}` of {}: `{}`; --view NAME or --all-views draws others\n",
                  drawn.name, count, fmt::join(names, "`, `")));
}

void Renderer::draw(const Target& target) {
  const auto start = std::chrono::steady_clock::now();
  const tracer::Options& options = command_.options;
  const int rows =
      options.region ? options.region->y1 - options.region->y0 : options.rows.value_or(target.view.rows);
  tracer::Rendered rendered;
  {
    Progress progress(console_.is_watched && !command_.quiet, target.name, rows);
    const auto on_rows = [&](int y0, int y1, const float*) { progress.add(y1 - y0); };
    rendered = session_.render(target.view, options, {&console_.interrupt, on_rows});
  }
  if (rendered.cancelled || console_.interrupt) throw Stopped{};
  write(target, rendered.image);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  tell(target, rendered, seconds.count());
}

void Renderer::write(const Target& target, const image::Image& picture) {
  const std::string bytes = image::encode(picture, format_, session_.scene().settings.exposure);
  if (console_.interrupt) throw Stopped{};
  if (target.path == k_stream) {
    console_.out.write(bytes);
    console_.out.flush();
  } else if (const auto problem = image::write_file_atomically(target.path, bytes)) {
    complain(*problem);
    throw Ended{k_file_trouble};
  }
}

/// What was left out, with what it would have been; empty where nothing was.
std::string saved_text(const tracer::Stats& s) {
  std::string out;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, what);
  };
  add(s.lights_behind, "shadow rays to lights behind the surface");
  add(s.lights_outside_cone, "to lights aimed elsewhere");
  add(s.lights_unanswered, "from surfaces that send none of the light back");
  add(s.lights_faint, "to lights too weak to show");
  add(s.rays_faint, "reflected and refracted rays too weak to show");
  return out.empty() ? out : fmt::format("  not shot       {}\n", out);
}

/// How the pixels came to their samples.
std::string sampling_text(const RenderStats& stats) {
  if (stats.samples > 0) return fmt::format("{} samples each", stats.samples);
  const tracer::Stats& s = stats.tracer;
  const auto pixels = static_cast<double>(std::max<std::uint64_t>(s.pixels, 1));
  const auto percent = [&](std::uint64_t count) { return 100 * static_cast<double>(count) / pixels; };
  return fmt::format("{:.2f} samples each for an error of {}; {:.1f}% refined, {:.1f}% along one edge",
                     static_cast<double>(s.primary_rays) / pixels, stats.error, percent(s.refined_pixels),
                     percent(s.edge_pixels));
}

std::string stats_text(const RenderStats& stats) {
  const tracer::Stats& s = stats.tracer;
  return fmt::format(
      "view `{}`: {} x {} pixels, {}, {} threads\n"
      "  script         {} steps, {} shapes, {} lights\n"
      "  rays           {} primary, {} reflected, {} refracted, {} shadow\n"
      "{}"
      "  tests          {} of shapes, {} of nodes\n"
      "  surfaces       {} looked at for rays that go on, {} for open solids, {} colours of patterns\n"
      "  seconds        {:.3f} preparing, {:.3f} drawing, {:.3f} in all\n",
      stats.view, stats.width, stats.height, sampling_text(stats), s.threads, stats.steps, stats.shapes,
      stats.lights, s.primary_rays, s.reflected_rays, s.refracted_rays, s.shadow_rays, saved_text(s),
      s.shape_tests, s.node_visits, s.branchings, s.medium_changes, s.pattern_lookups, s.build_seconds,
      s.render_seconds, stats.total_seconds);
}

void Renderer::tell(const Target& target, const tracer::Rendered& rendered, double seconds) {
  const int width = rendered.image.width(), height = rendered.image.height();
  const bool is_stream = target.path == k_stream;
  if (!command_.quiet) {
    say(fmt::format("wrote {}, {} x {}, in {:.2f} s\n",
                    is_stream ? "the picture to standard output" : target.path, width, height, seconds));
  }
  if (command_.stats == StatsFormat::none) return;
  const RenderStats stats{target.path,
                          target.name,
                          width,
                          height,
                          command_.options.samples,
                          command_.options.error,
                          steps_,
                          session_.scene().shapes.size(),
                          session_.scene().lights.size(),
                          rendered.stats,
                          seconds};
  if (command_.stats == StatsFormat::text) {
    say(stats_text(stats));
  } else {
    is_stream ? say(to_json(stats)) : console_.out.write(to_json(stats));
  }
}

}  // namespace

int render(const RenderCommand& command, const Console& console) {
  try {
    Renderer(command, console).run();
  } catch (const Ended& ended) {
    return ended.exit_code;
  } catch (const UsageError& problem) {
    complain(problem.what());
    return k_command_wrong;
  }
  return k_fine;
}

}  // namespace lancer::app
