// :views, :view, :render, :plan, :stats, :time and :set.

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

#include "app/find_view.hpp"
#include "app/option_values.hpp"
#include "app/output_path.hpp"
#include "app/plan_command.hpp"
#include "app/progress.hpp"
#include "app/repl/commands.hpp"
#include "image/encode.hpp"
#include "image/file.hpp"

namespace lancer::app {
namespace {

constexpr std::int64_t k_most_samples = 1 << 20;
constexpr std::int64_t k_most_threads = 1024;

void draw(Talk& talk, std::size_t index, const std::string& path) {
  const session::Session& session = talk.document.session();
  const scene::View view = session.views()[index];
  const int columns = talk.options.columns.value_or(view.columns);
  const int rows = talk.options.rows.value_or(view.rows);
  const auto format = image::format_from_path(path).value_or(image::Format::png8);
  if (const auto problem = image::can_write(path)) throw UsageError(*problem);
  tracer::Rendered rendered;
  {
    Progress progress(talk.console.is_watched, session.view_name(index), rows);
    const auto on_rows = [&](int y0, int y1, const float*) { progress.add(y1 - y0); };
    rendered = session.render(view, talk.options, {&talk.console.interrupt, on_rows});
  }
  if (rendered.cancelled || talk.console.interrupt) throw Stopped{};
  const std::string bytes = image::encode(rendered.image, format, session.scene().settings.exposure);
  if (const auto problem = image::write_file_atomically(path, bytes)) throw UsageError(*problem);
  talk.stats = rendered.stats;
  talk.has_stats = true;
  talk.tell(
      fmt::format("wrote {}: view `{}`, {} x {} pixels\n", path, session.view_name(index), columns, rows));
}

std::string settings_text(const Talk& talk) {
  const tracer::Options& o = talk.options;
  std::string out =
      o.columns ? fmt::format("size     {},{}\n", *o.columns, *o.rows) : "size     of the view\n";
  out += o.samples > 0 ? fmt::format("samples  {}\n", o.samples) : fmt::format("error    {}\n", o.error);
  return out + (o.threads > 0 ? fmt::format("threads  {}\n", o.threads) : "threads  as many as there are\n");
}

}  // namespace

void views_command(Talk& talk, const Words&) {
  const session::Session& session = talk.document.session();
  const std::vector<scene::View> views = session.views();
  const std::size_t current = talk.view_index();
  std::string out;
  for (std::size_t i = 0; i < views.size(); ++i)
    out += fmt::format("{} {}  {} x {}\n", i == current ? '*' : ' ', session.view_name(i), views[i].columns,
                       views[i].rows);
  talk.tell(out);
}

void view_command(Talk& talk, const Words& words) {
  find_view(talk.document.session(), words[0]);
  talk.view = words[0];
}

void render_command(Talk& talk, const Words& words) {
  const session::Session& session = talk.document.session();
  Words names = words;
  std::string path = beside_script(talk.path.empty() ? "session.scn" : talk.path, image::Format::png8);
  if (!names.empty() && image::format_from_path(names.back())) {
    path = names.back();
    names.pop_back();
  }
  std::vector<std::size_t> chosen;
  for (const std::string& name : names) chosen.push_back(find_view(session, name));
  if (chosen.empty()) chosen.push_back(talk.view_index());
  if (chosen.size() == 1) return draw(talk, chosen[0], path);
  const std::vector<std::string> paths = paths_of_views(path, names);
  for (std::size_t i = 0; i < chosen.size(); ++i) draw(talk, chosen[i], paths[i]);
}

void plan_command(Talk& talk, const Words&) {
  const session::Document& document = talk.document;
  talk.tell(to_text(plan_report(document.session(), talk.view_index(), document.name(), talk.options)));
}

void stats_command(Talk& talk, const Words&) {
  if (!talk.has_stats) throw UsageError("there is no picture yet; :render draws one");
  const tracer::Stats& s = talk.stats;
  talk.tell(
      fmt::format("pixels          {}\nprimary rays    {}\nreflected rays  {}\nrefracted rays  {}\n"
                  "shadow rays     {}\n",
                  s.pixels, s.primary_rays, s.reflected_rays, s.refracted_rays, s.shadow_rays));
}

/// The value is data; how long it took is not the same each time.
void time_command(Talk& talk, const Words& words) {
  const auto start = std::chrono::steady_clock::now();
  const session::Reply reply = talk.document.enter(fmt::format("({})", words[0]), talk.run);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  talk.answer(reply);
  say(fmt::format("{:.3f} s and {} steps, all of the scene before it included\n", seconds.count(),
                  reply.run.steps));
}

void set_command(Talk& talk, const Words& words) {
  if (words.empty()) return talk.tell(settings_text(talk));
  if (words.size() == 1)
    throw UsageError(fmt::format(":set {0} takes a value, such as :set size 320,240", words[0]));
  const std::string& value = words[1];
  if (words[0] == "size") {
    read_size(value, talk.options);
  } else if (words[0] == "samples") {
    talk.options.samples = static_cast<int>(read_whole("samples", value, 1, k_most_samples));
    talk.options.error = 0;
  } else if (words[0] == "error") {
    talk.options.error = read_error(value);
    talk.options.samples = 0;
  } else if (words[0] == "threads") {
    talk.options.threads = static_cast<int>(read_whole("threads", value, 0, k_most_threads));
  } else {
    throw UsageError(fmt::format("`{}` is not set here; size, samples, error and threads are", words[0]));
  }
}

}  // namespace lancer::app
