#pragma once
// Standard input, a line at a time.

#include <optional>
#include <string>

namespace lancer::app {

class Lines {
 public:
  /// The next line without its end, the last one even where it has none; nothing at the end of input. Throws
  /// Stopped where a signal came first, OutputError where input cannot be read.
  std::optional<std::string> next();

 private:
  std::string buffer_;
  bool is_at_end_ = false;
};

}  // namespace lancer::app
