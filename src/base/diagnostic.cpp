#include "base/diagnostic.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

namespace lancer {
namespace {

constexpr std::size_t k_window = 120;  // cells of a source line that are shown
constexpr std::size_t k_lead_in = 40;  // of them before the span where a line is cut
constexpr std::size_t k_most_errors = 20;
constexpr std::size_t k_trace_end = 4;  // calls listed at either end of a long trace

constexpr std::string_view k_replacement = "\xEF\xBF\xBD";
constexpr std::string_view k_bom = "\xEF\xBB\xBF";

/// What a terminal would be told, without colours all empty.
struct Palette {
  std::string_view bold, quiet, severity, reset;
};

Palette palette(Severity severity, bool color) {
  if (!color) return {};
  const std::string_view accent = severity == Severity::error     ? "\x1b[1;31m"
                                  : severity == Severity::warning ? "\x1b[1;33m"
                                                                  : "\x1b[1;36m";
  return {"\x1b[1m", "\x1b[1;34m", accent, "\x1b[0m"};
}

/// The length of the character at the start of `text`; 0 where it is no UTF-8.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  return length;
}

/// One character of a source line as shown. What would disturb a terminal shows as the replacement character.
struct Cell {
  std::size_t offset;  // in the line
  std::string_view shown;
};

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  const bool c1 = first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
  return first < 0x20 || first == 0x7F || c1;
}

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t i = line.starts_with(k_bom) ? k_bom.size() : 0; i < line.size();) {
    const std::size_t length = character_length(line.substr(i));
    const std::string_view character = line.substr(i, std::max<std::size_t>(length, 1));
    const bool plain = length > 0 && (character == "\t" || !is_control(character));
    cells.push_back({i, plain ? character : k_replacement});
    i += character.size();
  }
  return cells;
}

/// `text` with its further lines indented and nothing in it that a terminal would obey.
std::string calm(std::string_view text) {
  std::string out;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    for (const Cell& cell : cells_of(text.substr(begin, end - begin))) out += cell.shown;
    if (end == text.size()) return out;
    out += "\n     ";
    begin = end + 1;
  }
}

std::size_t cell_at(const std::vector<Cell>& cells, std::size_t offset) {
  const auto after = std::partition_point(cells.begin(), cells.end(),
                                          [&](const Cell& cell) { return cell.offset < offset; });
  return static_cast<std::size_t>(after - cells.begin());
}

/// A line of a script and the line of carets below it, cut to a window around the span.
struct Marked {
  std::string line, carets;
};

Marked mark(std::string_view line, std::size_t begin, std::size_t end) {
  const std::vector<Cell> cells = cells_of(line);
  const std::size_t first = cell_at(cells, begin);
  const std::size_t last = std::max(cell_at(cells, end), first + 1);
  std::size_t from = 0;
  std::size_t to = cells.size();
  if (cells.size() > k_window) {
    if (last > k_window) from = first > k_lead_in ? first - k_lead_in : 0;
    to = std::min(from + k_window, cells.size());
  }
  Marked out;
  if (from > 0) {
    out.line = "...";
    out.carets = "   ";
  }
  for (std::size_t i = from; i < to; ++i) out.line += cells[i].shown;
  if (to < cells.size()) out.line += "...";
  for (std::size_t i = from; i < first; ++i) out.carets += cells[i].shown == "\t" ? '\t' : ' ';
  out.carets.append(std::max(std::min(last, to), first + 1) - first, '^');
  return out;
}

std::string place(Span span, const SourceMap& sources) {
  const Source& source = sources[span.file];
  const Position at = source.position(span.begin);
  return fmt::format("{}:{}:{}", calm(source.name()), at.line, at.column);
}

/// The line with the span marked, between gutters of `width` columns.
std::string snippet(Span span, const SourceMap& sources, std::size_t width, const Palette& colors) {
  const Source& source = sources[span.file];
  const std::uint32_t number = source.position(span.begin).line;
  const std::uint32_t start = source.line_start(number);
  const std::string_view line = source.line(number);
  const Marked marked = mark(line, span.begin - start, std::max(span.end, span.begin) - start);
  return fmt::format("{0}{1:{2}} |{3}\n{0}{4:>{2}} |{3}{5}{6}\n{0}{1:{2}} |{3} {7}{8}{3}\n", colors.quiet, "",
                     width, colors.reset, number, marked.line.empty() ? "" : " ", marked.line,
                     colors.severity, marked.carets);
}

std::string_view word(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

/// The columns that line numbers need.
std::size_t gutter(const Diagnostic& d, const SourceMap& sources) {
  std::uint32_t largest = sources[d.span.file].position(d.span.begin).line;
  for (const Label& l : d.labels)
    largest = std::max(largest, sources[l.span.file].position(l.span.begin).line);
  return std::to_string(largest).size();
}

std::string remark(std::string_view kind, std::string_view text, std::size_t width, const Palette& colors) {
  return fmt::format("{:{}} {}={} {}{}:{} {}\n", "", width, colors.quiet, colors.reset, colors.bold, kind,
                     colors.reset, text);
}

std::string trace_text(const Diagnostic& d, const SourceMap& sources, std::size_t width,
                       const Palette& colors) {
  std::string out;
  const std::size_t count = d.trace.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i == k_trace_end && count > 2 * k_trace_end + 1) {
      const std::size_t skipped = count - 2 * k_trace_end;
      out += remark("in", fmt::format("... {} more calls", skipped), width, colors);
      i += skipped;
    }
    const Label& call = d.trace[i];
    out += remark("in", fmt::format("{} at {}", calm(call.text), place(call.span, sources)), width, colors);
  }
  return out;
}

}  // namespace

std::string code_name(Code code) {
  const auto number = static_cast<unsigned>(code);
  if (number == 0) return "";
  return fmt::format("{}{:03}", number > 100 ? 'W' : 'E', number);
}

std::string to_text(const Diagnostic& d, const SourceMap& sources, bool color) {
  const Palette colors = palette(d.severity, color);
  const std::string code = d.code == Code::none ? "" : "[" + code_name(d.code) + "]";
  const std::string headline = fmt::format("{}{}{}:{} {}{}{}\n", colors.severity, word(d.severity), code,
                                           colors.reset, colors.bold, calm(d.message), colors.reset);
  if (d.span.file >= sources.size()) return headline;
  const std::size_t width = gutter(d, sources);
  std::string out = fmt::format("{}{}:{} ", colors.bold, place(d.span, sources), colors.reset) + headline;
  out += snippet(d.span, sources, width, colors);
  if (!d.help.empty()) out += remark("help", calm(d.help), width, colors);
  out += trace_text(d, sources, width, colors);
  const Palette note = palette(Severity::note, color);
  for (const Label& label : d.labels) {
    out += fmt::format("{}{}:{} {}note:{} {}\n", note.bold, place(label.span, sources), note.reset,
                       note.severity, note.reset, calm(label.text));
    out += snippet(label.span, sources, width, note);
  }
  return out;
}

std::string to_text(std::vector<Diagnostic> diagnostics, const SourceMap& sources, bool color) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(a.span.file, a.span.begin) < std::tuple(b.span.file, b.span.begin);
  });
  std::string out;
  std::size_t errors = 0;
  for (const Diagnostic& d : diagnostics) {
    if (d.severity == Severity::error && ++errors > k_most_errors) continue;
    if (!out.empty()) out += "\n";
    out += to_text(d, sources, color);
  }
  if (errors > k_most_errors) {
    const std::size_t more = errors - k_most_errors;
    out += fmt::format("\n... and {} more error{}\n", more, more == 1 ? "" : "s");
  }
  return out;
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

}  // namespace lancer
