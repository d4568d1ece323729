#pragma once
// The bar that shows how much of a picture is done, on a terminal only.

#include <chrono>
#include <string>

namespace lancer::app {

class Progress {
 public:
  /// Draws nothing unless `is_shown`.
  Progress(bool is_shown, std::string title, int rows);
  /// Takes the bar away again.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// So many more rows are finished. Not from two threads at once.
  void add(int rows);

 private:
  void draw();

  bool is_shown_;
  std::string title_;
  int rows_;
  int done_ = 0;
  int columns_ = 0;  // of the terminal
  std::chrono::steady_clock::time_point next_draw_;
};

/// "front [#####.....]  50 %", no wider than `columns`.
std::string progress_line(const std::string& title, int done, int rows, int columns);

}  // namespace lancer::app
