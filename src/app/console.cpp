#include "app/console.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

namespace lancer::app {
namespace {

constexpr std::size_t k_buffer_size = 1 << 16;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool is_dumb() {
  const char* terminal = std::getenv("TERM");
  return terminal == nullptr || std::string_view(terminal) == "dumb";
}

}  // namespace

Output::Output(const std::atomic<bool>& interrupt)
    : interrupt_(interrupt), is_terminal_(isatty(STDOUT_FILENO) == 1) {}

void Output::write(std::string_view text) {
  buffer_ += text;
  if (is_terminal_ || buffer_.size() >= k_buffer_size) flush();
}

void Output::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, rest.data(), rest.size());
    if (count >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      const std::string reason = std::generic_category().message(errno);
      buffer_.clear();
      throw OutputError("cannot write to standard output: " + reason);
    } else if (interrupt_) {
      buffer_.clear();
      throw Stopped{};
    }
  }
  buffer_.clear();
}

void say(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

void complain(std::string_view line) { say(fmt::format("lancer: {}\n", line)); }

Console make_console(Output& out, const std::atomic<bool>& interrupt) {
  const bool is_watched = isatty(STDERR_FILENO) == 1 && !is_dumb();
  return {out, interrupt, is_watched && !is_set("NO_COLOR"), is_watched};
}

}  // namespace lancer::app
