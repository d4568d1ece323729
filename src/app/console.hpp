#pragma once
// Standard output and standard error.

#include <atomic>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lancer::app {

/// Standard output could not be written; what() says why, in one line.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The user asked to stop while the program waited for input or output.
struct Stopped {};

/// Standard output. What is written waits in a buffer, to the end of the line on a terminal.
class Output {
 public:
  explicit Output(const std::atomic<bool>& interrupt);
  /// Throws OutputError or Stopped.
  void write(std::string_view text);
  void flush();
  bool is_terminal() const { return is_terminal_; }

 private:
  const std::atomic<bool>& interrupt_;
  bool is_terminal_;
  std::string buffer_;
};

/// What the commands need of the world around them.
struct Console {
  Output& out;
  const std::atomic<bool>& interrupt;
  bool colors;      // on standard error
  bool is_watched;  // standard error is a terminal
};

/// To standard error, as it is; a failure there has nowhere to be told.
void say(std::string_view text);
/// "lancer: <line>" and a newline.
void complain(std::string_view line);

Console make_console(Output& out, const std::atomic<bool>& interrupt);

}  // namespace lancer::app
