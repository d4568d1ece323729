// :save, :open, :reload, :diff and :reset.

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

#include "app/option_values.hpp"
#include "app/repl/commands.hpp"
#include "image/file.hpp"

namespace lancer::app {
namespace {

using Lines = std::vector<std::string>;

/// Beyond so many pairs of lines the middle is told as a whole.
constexpr std::size_t k_most_pairs = 4'000'000;

Lines lines_of(const std::string& text) {
  Lines out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

/// Lines taken away and added, by the longest common subsequence of what lies between what is the same at
/// both ends.
std::string difference(Lines a, Lines b) {
  const auto same_start = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  b.erase(b.begin(), same_start.second);
  a.erase(a.begin(), same_start.first);
  while (!a.empty() && !b.empty() && a.back() == b.back()) a.pop_back(), b.pop_back();
  const std::size_t n = a.size(), m = b.size();
  const bool is_small = (n + 1) * (m + 1) <= k_most_pairs;
  std::vector<std::vector<std::uint32_t>> common(is_small ? n + 1 : 0, std::vector<std::uint32_t>(m + 1));
  for (std::size_t i = is_small ? n : 0; i-- > 0;) {
    for (std::size_t j = m; j-- > 0;)
      common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  }
  std::string out;
  std::size_t i = 0, j = 0;
  while (i < n || j < m) {
    if (is_small && i < n && j < m && a[i] == b[j]) {
      ++i, ++j;
    } else if (i < n && (j == m || !is_small || common[i + 1][j] >= common[i][j + 1])) {
      out += "- " + a[i++] + "\n";
    } else {
      out += "+ " + b[j++] + "\n";
    }
  }
  return out;
}

std::string read_file(Talk& talk, const std::string& path) {
  const std::string canonical = talk.host.canonical(path);
  session::FileText file = canonical.empty()
                               ? session::FileText{session::FileText::Status::missing, {}, "no such file"}
                               : talk.host.read(canonical);
  if (file.status != session::FileText::Status::read)
    throw UsageError(fmt::format("cannot read {}: {}", path, file.problem));
  return std::move(file.text);
}

}  // namespace

void save_command(Talk& talk, const Words& words) {
  if (words.empty() && talk.path.empty()) throw UsageError("name a file: :save lamp.scn");
  const std::string path = words.empty() ? talk.path : words[0];
  if (const auto problem = image::write_file_atomically(path, talk.document.text()))
    throw UsageError(*problem);
  talk.path = path;
  talk.document.set_name(path);
  talk.saved = talk.document.text();
  talk.tell(fmt::format("saved {}\n", path));
}

void open_command(Talk& talk, const Words& words) {
  std::string text = read_file(talk, words[0]);
  talk.answer(talk.document.open(words[0], std::move(text), talk.run));
  talk.path = words[0];
  talk.saved = talk.document.text();
  talk.view.clear();
}

void reload_command(Talk& talk, const Words&) {
  if (talk.path.empty()) throw UsageError("there is no file to read again; :open FILE reads one");
  const std::string text = read_file(talk, talk.path);
  talk.answer(talk.document.change(text, talk.run, ":reload"));
  talk.saved = text;
}

void diff_command(Talk& talk, const Words&) {
  talk.tell(difference(lines_of(talk.saved), lines_of(talk.document.text())));
}

void reset_command(Talk& talk, const Words&) { talk.answer(talk.document.change("", talk.run, ":reset")); }

}  // namespace lancer::app
