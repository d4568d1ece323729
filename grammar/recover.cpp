// Where to go on after a mistake. Reads brackets, strings and comments, and knows the words that begin
// statements.

#include <algorithm>
#include <vector>

#include "grammar/builder.hpp"
#include "grammar/lexemes.hpp"
#include "lang/keywords.hpp"

namespace lancer::grammar {
namespace {

std::ptrdiff_t column(std::string_view text, const char* at) {
  const char* line = at;
  while (line != text.data() && line[-1] != '\n') --line;
  return at - line;
}

bool first_on_line(std::string_view text, const char* at) {
  while (at != text.data() && (at[-1] == ' ' || at[-1] == '\t')) --at;
  return at == text.data() || at[-1] == '\n';
}

char closer_of(char opener) { return opener == '(' ? ')' : opener == '[' ? ']' : '}'; }

/// Behind one token; strings and words are one each. `word` is set where it is a word.
const char* skip_token(const char* at, const char* end, std::string_view& word) {
  word = word_at(at, end);
  if (!word.empty()) return word.data() + word.size();
  if (*at == '"') return skip_string(at, end);
  return at + 1;
}

/// Pops the opener that `closer` belongs to, and what was left open within it; false where there is none.
bool close(std::vector<char>& open, char closer) {
  const auto found = std::find_if(open.rbegin(), open.rend(), [&](char o) { return closer_of(o) == closer; });
  if (found == open.rend()) return false;
  open.erase(found.base() - 1, open.end());
  return true;
}

}  // namespace

bool begins_statement(std::string_view word) {
  const auto words = lang::statement_words();
  return std::find(words.begin(), words.end(), word) != words.end() || lang::find_kind(word).has_value();
}

const char* next_statement(std::string_view text, const char* start, const char* failed) {
  const char* end = text.data() + text.size();
  const std::ptrdiff_t start_column = column(text, start);
  std::vector<char> open;
  const char* at = start;
  while (at != end) {
    const char* token = behind_blank(at, end);
    const bool behind = token >= failed && token != start;
    const bool line_break = std::find(at, token, '\n') != token;
    if (token == end) return end;
    if (behind && open.empty() && (line_break || *token == '}')) return token;
    std::string_view word;
    const char* next = skip_token(token, end, word);
    if (behind && begins_statement(word)) {
      if (open.empty() && token > failed) return token;
      if (first_on_line(text, token) && column(text, token) <= start_column) return token;
    }
    if (*token == '(' || *token == '[' || *token == '{') open.push_back(*token);
    if ((*token == ')' || *token == ']' || *token == '}') && !close(open, *token) && *token == '}' && behind)
      return token;
    if (behind && open.empty() && *token == ';') return next;
    at = next;
  }
  return end;
}

const char* skip_braces(std::string_view text, const char* at) {
  const char* end = text.data() + text.size();
  int depth = 0;
  while (at != end) {
    at = behind_blank(at, end);
    if (at == end) return end;
    const char c = *at;
    std::string_view word;
    at = skip_token(at, end, word);
    if (c == '{') ++depth;
    if (c == '}' && --depth == 0) return at;
  }
  return end;
}

}  // namespace lancer::grammar
