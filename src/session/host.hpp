#pragma once
// What a session needs from the outside: files and somewhere to print. The core touches neither disk nor
// console, so a new front end is one small class.

#include <string>
#include <string_view>
#include <vector>

namespace lancer::session {

/// The outcome of asking for a file.
struct FileText {
  enum class Status { read, missing, unreadable };
  Status status = Status::missing;
  std::string text;
  std::string problem;  // what the system said, where unreadable
};

class Host {
 public:
  virtual ~Host() = default;

  /// The whole file at a canonical path.
  virtual FileText read(const std::string& canonical) = 0;
  /// The path with links and `..` resolved; empty where nothing is there.
  virtual std::string canonical(const std::string& path) = 0;
  /// What `print` in a script writes; whole lines.
  virtual void print(std::string_view text) = 0;
};

}  // namespace lancer::session
