#pragma once
// Files from the disk, printed lines to wherever the command wants them.

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

#include "session/host.hpp"

namespace lancer::app {

class DiskHost : public session::Host {
 public:
  using Print = std::function<void(std::string_view)>;

  /// `print` may be empty: then nothing is printed.
  DiskHost(Print print, const std::atomic<bool>& interrupt)
      : print_(std::move(print)), interrupt_(interrupt) {}

  session::FileText read(const std::string& canonical) override;
  std::string canonical(const std::string& path) override;
  void print(std::string_view text) override;

  /// All of standard input.
  session::FileText read_input();

 private:
  session::FileText read_all(int descriptor);

  Print print_;
  const std::atomic<bool>& interrupt_;
};

}  // namespace lancer::app
