#include "base/source.hpp"

#include <algorithm>
#include <utility>

namespace lancer {

Source::Source(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), line_starts_{0} {
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1)) {
    line_starts_.push_back(static_cast<std::uint32_t>(at + 1));
  }
}

Position Source::position(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const std::uint32_t start = *(after - 1);
  const std::string_view before = std::string_view(text_).substr(start, offset - start);
  const auto is_lead = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  auto column = static_cast<std::uint32_t>(std::count_if(before.begin(), before.end(), is_lead)) + 1;
  const bool bom = start == 0 && text_.starts_with("\xEF\xBB\xBF") && offset >= 3;
  return {static_cast<std::uint32_t>(after - line_starts_.begin()), bom ? column - 1 : column};
}

std::string_view Source::line(std::uint32_t number) const {
  const std::uint32_t begin = line_starts_[number - 1];
  std::size_t end = number < line_starts_.size() ? line_starts_[number] - 1 : text_.size();
  std::string_view line = std::string_view(text_).substr(begin, end - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::uint32_t SourceMap::add(std::string name, std::string text) {
  sources_.emplace_back(std::move(name), std::move(text));
  return size() - 1;
}

std::string_view SourceMap::text(Span span) const {
  return std::string_view(sources_[span.file].text()).substr(span.begin, span.end - span.begin);
}

}  // namespace lancer
