#include "app/progress.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "app/console.hpp"

namespace lancer::app {
namespace {

constexpr int k_widest = 78;
constexpr int k_bar = 30;
constexpr std::chrono::milliseconds k_pause{100};

int terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return k_widest;
  return std::min<int>(size.ws_col - 1, k_widest);
}

}  // namespace

std::string progress_line(const std::string& title, int done, int rows, int columns) {
  const double part = rows > 0 ? static_cast<double>(done) / rows : 1;
  const std::string percent = fmt::format("{:3} %", static_cast<int>(part * 100));
  const int room = columns - static_cast<int>(percent.size()) - 4;
  if (room < 1) return columns >= static_cast<int>(percent.size()) ? percent : "";
  const int bar = std::min(k_bar, room);
  const int full = static_cast<int>(part * bar);
  std::string line = fmt::format("[{:#<{}}{:.<{}}] {}", "", full, "", bar - full, percent);
  if (columns - static_cast<int>(line.size()) > static_cast<int>(title.size()))
    line = fmt::format("{} {}", title, line);
  return line;
}

Progress::Progress(bool is_shown, std::string title, int rows)
    : is_shown_(is_shown),
      title_(std::move(title)),
      rows_(rows),
      next_draw_(std::chrono::steady_clock::now()) {
  if (is_shown_) columns_ = terminal_columns();
}

Progress::~Progress() {
  if (is_shown_) say(fmt::format("\r{:{}}\r", "", columns_));
}

void Progress::add(int rows) {
  done_ += rows;
  if (!is_shown_ || std::chrono::steady_clock::now() < next_draw_) return;
  draw();
  next_draw_ = std::chrono::steady_clock::now() + k_pause;
}

void Progress::draw() { say(fmt::format("\r{}", progress_line(title_, done_, rows_, columns_))); }

}  // namespace lancer::app
