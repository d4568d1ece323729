// The only file that includes nlohmann/json.hpp, which is slow to compile.

#include "stress/report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lancer::stress {
namespace {

std::string painted(const std::string& text, const char* color, bool colored) {
  return colored ? fmt::format("\x1b[{}m{}\x1b[0m", color, text) : text;
}
constexpr const char* k_bold = "1";
constexpr const char* k_dim = "2";
constexpr const char* k_green = "32";
constexpr const char* k_red = "1;31";

/// At most 8 characters.
std::string short_number(double value) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return "inf";
  const double size = std::fabs(value);
  if (size < 1e15 && value == std::floor(value) && size < 1e6) return fmt::format("{:.0f}", value);
  if (size >= 1e5 || size < 0.00995) return fmt::format("{:.1e}", value);
  return fmt::format("{:.{}f}", value, size < 99.95 ? 2 : 1);
}

std::string count(std::uint64_t value, const Measure& of) {
  if (of.rays == 0) return "-";
  std::string digits = std::to_string(value);
  if (digits.size() > 9) return fmt::format("{:.2e}", static_cast<double>(value));
  return digits;
}

constexpr const char* k_columns =
    "  method                           rays  dist max     99.9%     point    normal    wrong  in band    "
    "leaks  "
    "   self"
    "       ns  worst of";

std::string line(const Measure& m) {
  return fmt::format("{} {:<26}{:>10}{:>10}{:>10}{:>10}{:>10}{:>9}{:>9}{:>9}{:>9}{:>9}{}{}",
                     m.in_use ? '>' : ' ', m.method, count(m.rays, m), short_number(m.distance_max),
                     short_number(m.distance_999), short_number(m.point_max), short_number(m.normal_max),
                     count(m.wrong, m), count(m.in_band, m), count(m.leaks, m), count(m.self_hits, m),
                     short_number(m.nanoseconds), m.set.empty() ? "" : "  ", m.set);
}

std::string limits_line(const Outcome& outcome, bool met) {
  std::string text;
  for (const Limit& limit : outcome.limits) {
    if (limit.met() != met) continue;
    text += fmt::format("{}{} {} {} {}", text.empty() ? "" : "; ", limit.what, short_number(limit.value),
                        met ? "<=" : "is not <=", short_number(limit.limit));
  }
  return text;
}

nlohmann::ordered_json number(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

nlohmann::ordered_json json_of(const Measure& m) {
  return {{"method", m.method},
          {"in_use", m.in_use},
          {"set", m.set},
          {"rays", m.rays},
          {"distance_max", number(m.distance_max)},
          {"distance_999", number(m.distance_999)},
          {"point_max", number(m.point_max)},
          {"normal_max", number(m.normal_max)},
          {"wrong", m.wrong},
          {"in_band", m.in_band},
          {"leaks", m.leaks},
          {"self_hits", m.self_hits},
          {"nanoseconds", number(m.nanoseconds)}};
}

nlohmann::ordered_json json_of(const Report& report) {
  auto measures = nlohmann::ordered_json::array();
  for (const Measure& measure : report.outcome.measures) measures.push_back(json_of(measure));
  auto limits = nlohmann::ordered_json::array();
  for (const Limit& limit : report.outcome.limits) {
    limits.push_back({{"what", limit.what},
                      {"value", number(limit.value)},
                      {"limit", number(limit.limit)},
                      {"met", limit.met()}});
  }
  return {{"name", report.name},       {"about", report.about}, {"seconds", report.seconds},
          {"measures", measures},      {"limits", limits},      {"note", report.outcome.note},
          {"failure", report.failure}, {"met", report.met()}};
}

}  // namespace

std::string as_table(const Report& report, bool colored) {
  std::string text =
      fmt::format("{}: {} ({:.1f} s)\n", painted(report.name, k_bold, colored), report.about, report.seconds);
  if (!report.outcome.measures.empty()) text += painted(k_columns, k_dim, colored) + '\n';
  for (const Measure& measure : report.outcome.measures) text += line(measure) + '\n';
  const std::string met = limits_line(report.outcome, true), missed = limits_line(report.outcome, false);
  if (!met.empty()) text += fmt::format("  {}: {}\n", painted("met", k_green, colored), met);
  if (!missed.empty()) text += fmt::format("  {}: {}\n", painted("MISSED", k_red, colored), missed);
  if (!report.failure.empty())
    text += fmt::format("  {}: {}\n", painted("FAILED", k_red, colored), report.failure);
  if (!report.outcome.note.empty()) text += fmt::format("  {}\n", report.outcome.note);
  return text;
}

std::string summary(const std::vector<Report>& reports, bool colored) {
  std::size_t limits = 0;
  double seconds = 0;
  std::vector<std::string> missed;
  for (const Report& report : reports) {
    limits += report.outcome.limits.size();
    seconds += report.seconds;
    if (!report.met()) missed.push_back(report.name);
  }
  const std::string all = fmt::format("{} rows with {} limits in {:.1f} s", reports.size(), limits, seconds);
  if (missed.empty()) return fmt::format("{}: {}\n", all, painted("every limit is met", k_green, colored));
  return fmt::format("{}: {} in {}\n", all, painted("limits are missed", k_red, colored),
                     fmt::join(missed, ", "));
}

std::string as_json(const std::vector<Report>& reports, const Settings& settings) {
  auto rows = nlohmann::ordered_json::array();
  for (const Report& report : reports) rows.push_back(json_of(report));
  const bool met = std::ranges::all_of(reports, [](const Report& r) { return r.met(); });
  const nlohmann::ordered_json all{
      {"long", settings.full}, {"seed", settings.seed}, {"met", met}, {"rows", rows}};
  return all.dump(2) + '\n';
}

}  // namespace lancer::stress
