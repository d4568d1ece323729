// The only file that includes nlohmann's json, which is slow to compile.

#include "app/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

namespace lancer::app {
namespace {

using Json = nlohmann::json;

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

const char* word(Severity severity) {
  switch (severity) {
    case Severity::error: return "error";
    case Severity::warning: return "warning";
    case Severity::note: return "note";
  }
  return "";
}

Json place(Span span, const SourceMap& sources) {
  if (span.file >= sources.size()) return Json::object();
  const Source& source = sources[span.file];
  const Position begin = source.position(span.begin), end = source.position(span.end);
  return {{"file", source.name()},
          {"line", begin.line},
          {"column", begin.column},
          {"end_line", end.line},
          {"end_column", end.column}};
}

Json labels(const std::vector<Label>& labels, const SourceMap& sources) {
  Json out = Json::array();
  for (const Label& label : labels) {
    Json entry = place(label.span, sources);
    entry["text"] = label.text;
    out.push_back(std::move(entry));
  }
  return out;
}

}  // namespace

std::string to_json(std::vector<Diagnostic> diagnostics, const SourceMap& sources) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(a.span.file, a.span.begin) < std::tuple(b.span.file, b.span.begin);
  });
  std::string out;
  for (const Diagnostic& d : diagnostics) {
    Json entry = place(d.span, sources);
    entry["severity"] = word(d.severity);
    entry["code"] = code_name(d.code);
    entry["message"] = d.message;
    entry["help"] = d.help;
    entry["labels"] = labels(d.labels, sources);
    entry["trace"] = labels(d.trace, sources);
    out += line_of(entry);
  }
  return out;
}

std::string problem_to_json(const std::string& file, const std::string& message) {
  return line_of({{"file", file}, {"severity", "error"}, {"message", message}});
}

std::string to_json(const RenderStats& stats) {
  const tracer::Stats& s = stats.tracer;
  return line_of({{"file", stats.path},
                  {"view", stats.view},
                  {"width", stats.width},
                  {"height", stats.height},
                  {"samples", stats.samples},
                  {"error", stats.error},
                  {"threads", s.threads},
                  {"steps", stats.steps},
                  {"shapes", stats.shapes},
                  {"lights", stats.lights},
                  {"pixels_refined", s.refined_pixels},
                  {"pixels_with_an_edge", s.edge_pixels},
                  {"primary_rays", s.primary_rays},
                  {"reflected_rays", s.reflected_rays},
                  {"refracted_rays", s.refracted_rays},
                  {"shadow_rays", s.shadow_rays},
                  {"shape_tests", s.shape_tests},
                  {"node_visits", s.node_visits},
                  {"branchings", s.branchings},
                  {"medium_changes", s.medium_changes},
                  {"pattern_lookups", s.pattern_lookups},
                  {"not_shot",
                   {{"lights_behind", s.lights_behind},
                    {"lights_outside_cone", s.lights_outside_cone},
                    {"lights_unanswered", s.lights_unanswered},
                    {"lights_faint", s.lights_faint},
                    {"rays_faint", s.rays_faint}}},
                  {"build_seconds", s.build_seconds},
                  {"render_seconds", s.render_seconds},
                  {"total_seconds", stats.total_seconds}});
}

std::string to_json(const PlanReport& report) {
  Json skips = Json::array();
  for (const PlanReport::Line& line : report.skips) {
    skips.push_back({{"name", line.name}, {"verdict", line.verdict}, {"what", line.what}, {"why", line.why}});
  }
  Json shapes = Json::object(), lights = Json::object();
  for (const auto& [kind, count] : report.shapes) shapes[kind] = count;
  for (const auto& [kind, count] : report.lights) lights[kind] = count;
  return line_of({{"file", report.file},
                  {"view", report.view},
                  {"other_views", report.other_views},
                  {"width", report.width},
                  {"height", report.height},
                  {"samples", report.samples},
                  {"error", report.error},
                  {"primary_rays", report.primary_rays},
                  {"depth", report.depth},
                  {"reflects", report.reflects},
                  {"transmits", report.transmits},
                  {"shadows", report.shadows},
                  {"structure", report.structure},
                  {"things", report.things},
                  {"materials", report.materials},
                  {"shapes", shapes},
                  {"lights", lights},
                  {"skips", skips}});
}

}  // namespace lancer::app
