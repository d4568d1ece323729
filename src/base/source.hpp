#pragma once
// Named texts, and places in them. Every message that Lancer gives about a script points here.

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

/// Bytes [begin, end) of the text number `file` of a SourceMap.
struct Span {
  std::uint32_t file = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// The span from the start of `a` to the end of `b`.
constexpr Span join(Span a, Span b) { return {a.file, a.begin, b.end}; }

/// A place as people read it: both from 1; columns are code points, a tab is one.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  friend bool operator==(const Position&, const Position&) = default;
};

class Source {
 public:
  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  Position position(std::uint32_t offset) const;
  /// The line (from 1) without its line end, LF or CR LF.
  std::string_view line(std::uint32_t number) const;
  std::uint32_t line_start(std::uint32_t number) const { return line_starts_[number - 1]; }

 private:
  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
};

/// The texts of one run. A Source stays where it is while others are added.
class SourceMap {
 public:
  std::uint32_t add(std::string name, std::string text);
  const Source& operator[](std::uint32_t file) const { return sources_[file]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(sources_.size()); }
  std::string_view text(Span span) const;

 private:
  std::deque<Source> sources_;
};

}  // namespace lancer
