// docs/refusals.md says what Lancer refuses and with which words; each row names the case that shows it. Here
// the page is held to the cases, and the cases (by scripts_test.cpp) to the program.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "scripts/expectations.hpp"

namespace {

namespace fs = std::filesystem;
using namespace lancer;

struct Row {
  std::string what, code, message, file;
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A cell without the blanks and the backticks of a code span around it.
std::string content_of(std::string cell) {
  const auto strip = [&](char c) {
    while (cell.starts_with(c)) cell.erase(0, 1);
    while (cell.ends_with(c)) cell.pop_back();
  };
  strip(' ');
  if (cell.starts_with("`` ") && cell.ends_with(" ``")) return cell.substr(3, cell.size() - 6);
  if (cell.size() > 1 && cell.starts_with('`') && cell.ends_with('`')) return cell.substr(1, cell.size() - 2);
  return cell;
}

/// The cells of a line `| a | b |`; `\|` is a bar within one.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> out;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
      cell += line[++i];
    } else if (line[i] == '|') {
      out.push_back(content_of(cell));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return out;
}

std::vector<Row> rows_of(const std::string& page) {
  std::vector<Row> out;
  std::istringstream lines{page};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('|')) continue;
    const std::vector<std::string> cells = cells_of(line);
    const bool is_head = cells.size() != 4 || cells[0] == "refused" || cells[0].starts_with("--");
    if (!is_head) out.push_back({cells[0], cells[1], cells[2], cells[3]});
  }
  return out;
}

/// Whether a case expects that error or warning.
bool expects(const std::string& text, const Row& row) {
  const test::Expectations all = test::parse_expectations(text);
  return std::any_of(all.messages.begin(), all.messages.end(),
                     [&](const test::Expected& e) { return e.code == row.code && e.message == row.message; });
}

}  // namespace

TEST_CASE("each row of the page of refusals is shown by its case", "[refusals]") {
  const fs::path root = LANCER_SCRIPTS_FOLDER;
  const std::vector<Row> rows = rows_of(text_of(root / "../../docs/refusals.md"));
  REQUIRE(rows.size() > 100);
  for (const Row& row : rows) {
    INFO(row.what << ": " << row.file);
    CHECK(fs::exists(root / row.file));
    CHECK(expects(text_of(root / row.file), row));
  }
}

TEST_CASE("each case of a refusal has a row on the page", "[refusals]") {
  const fs::path root = LANCER_SCRIPTS_FOLDER;
  std::set<std::string> shown;
  for (const Row& row : rows_of(text_of(root / "../../docs/refusals.md"))) shown.insert(row.file);
  for (const auto& entry : fs::directory_iterator(root / "refusals")) {
    if (entry.path().extension() != ".scn") continue;
    const std::string file = "refusals/" + entry.path().filename().string();
    INFO(file);
    CHECK(shown.count(file) == 1);
  }
}

TEST_CASE("the rows of a page are read as they are shown", "[refusals]") {
  const std::vector<Row> rows = rows_of(
      "| refused | code | message | case |\n| --- | --- | --- | --- |\nprose\n"
      "| bars | E048 | `` expected `)`, found `\\|\\|` `` | `refusals/a.scn` |\n");
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].what == "bars");
  CHECK(rows[0].code == "E048");
  CHECK(rows[0].message == "expected `)`, found `||`");
  CHECK(rows[0].file == "refusals/a.scn");
  CHECK(expects("a || b  //~ error E048 at 3: expected `)`, found `||`", rows[0]));
  CHECK_FALSE(expects("a || b  //~ error E001 at 3: expected `)`, found `||`", rows[0]));
}
