#include "app/repl/lines.hpp"

#include <array>
#include <cerrno>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "app/console.hpp"

namespace lancer::app {

std::optional<std::string> Lines::next() {
  std::array<char, 1 << 12> chunk;
  for (;;) {
    if (const std::size_t end = buffer_.find('\n'); end != std::string::npos) {
      std::string line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return line;
    }
    if (is_at_end_) {
      if (buffer_.empty()) return std::nullopt;
      return std::exchange(buffer_, {});
    }
    const ssize_t count = ::read(STDIN_FILENO, chunk.data(), chunk.size());
    if (count > 0) {
      buffer_.append(chunk.data(), static_cast<std::size_t>(count));
    } else if (count == 0) {
      is_at_end_ = true;
    } else if (errno == EINTR) {
      buffer_.clear();
      throw Stopped{};
    } else {
      throw OutputError("cannot read standard input: " + std::generic_category().message(errno));
    }
  }
}

}  // namespace lancer::app
