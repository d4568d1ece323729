#include "app/option_values.hpp"

#include <charconv>
#include <fmt/format.h>
#include <vector>

#include "base/diagnostic.hpp"

namespace lancer::app {
namespace {

constexpr std::int64_t k_largest_size = 65536;

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> out{""};
  for (const char c : text) {
    if (c == ',') {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

}  // namespace

std::int64_t read_whole(const std::string& option, const std::string& text, std::int64_t lowest,
                        std::int64_t highest) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc{} || rest != end || value < lowest || value > highest) {
    throw UsageError(
        fmt::format("{} takes a whole number from {} to {}; this is `{}`", option, lowest, highest, text));
  }
  return value;
}

double read_error(const std::string& text) {
  constexpr double k_least = 0.001, k_most = 1;
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc{} || rest != end || !(value >= k_least && value <= k_most)) {
    throw UsageError(fmt::format("--error takes a number from {} to {}, such as 0.02; this is `{}`", k_least,
                                 k_most, text));
  }
  return value;
}

void read_size(const std::string& text, tracer::Options& options) {
  const std::vector<std::string> parts = split_at_commas(text);
  if (parts.size() != 2)
    throw UsageError(fmt::format("--size takes W,H, such as 640,480; this is `{}`", text));
  options.columns = static_cast<int>(read_whole("--size", parts[0], 1, k_largest_size));
  options.rows = static_cast<int>(read_whole("--size", parts[1], 1, k_largest_size));
}

tracer::Region read_region(const std::string& text) {
  const std::vector<std::string> parts = split_at_commas(text);
  if (parts.size() != 4) throw UsageError(fmt::format("--region takes X0,Y0,X1,Y1; this is `{}`", text));
  const auto number = [&](std::size_t i) {
    return static_cast<int>(read_whole("--region", parts[i], 0, k_largest_size));
  };
  const tracer::Region region{number(0), number(1), number(2), number(3)};
  if (region.x0 >= region.x1 || region.y0 >= region.y1) {
    throw UsageError(fmt::format(
        "--region X0,Y0,X1,Y1 holds the pixels from X0,Y0 up to X1,Y1, which is excluded; {} is empty",
        text));
  }
  return region;
}

tracer::Skips read_skips(const std::string& text) {
  if (text == "true") return tracer::Skips::none();
  const std::vector<std::string_view> names(tracer::k_skip_names.begin(), tracer::k_skip_names.end());
  tracer::Skips skips = tracer::Skips::all();
  for (const std::string& name : split_at_commas(text)) {
    const std::optional<tracer::Skip> skip = tracer::skip_from_name(name);
    if (!skip) {
      const std::string_view near = nearest(name, names);
      throw UsageError(fmt::format("--no-skip: there is no skip `{}`{}; the skips are {}", name,
                                   near.empty() ? "" : fmt::format(" (did you mean `{}`?)", near),
                                   fmt::join(names, ", ")));
    }
    skips = skips.without(*skip);
  }
  return skips;
}

session::Define read_define(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError(fmt::format("-D takes name=value, such as n=12; this is `{}`", text));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace lancer::app
