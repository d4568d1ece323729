#pragma once
// Drives the built program as a shell would.

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace lancer::test {

/// A folder of its own for one test, gone at its end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& root() const { return path_; }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
  /// The names of everything in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

struct Result {
  int exit_code = -1;  // 128 + the signal, where one ended the program
  std::string out, err;
};

struct Setting {
  std::string input;          // standard input
  std::string folder;         // the working directory; empty: the test's own
  bool as_nobody = false;     // without the rights of the superuser
  std::string out_path;       // standard output goes to this file in place of Result::out
  unsigned largest_file = 0;  // bytes that a file may have; 0: any number
};

Result run_program(const std::vector<std::string>& arguments, const Setting& setting = {});

/// The program while it runs, with its input open and empty.
class Running {
 public:
  explicit Running(const std::vector<std::string>& arguments);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Waits until the program has written something to standard output.
  void wait_for_output();
  void close_output();
  void signal(int number) const;
  Result wait();

 private:
  pid_t process_ = -1;
  int in_ = -1, out_ = -1, err_ = -1;
  Result result_;
};

/// What the program writes to a terminal that is its standard error, and with `both` its standard output too.
Result run_on_terminal(const std::vector<std::string>& arguments, bool both,
                       const std::vector<std::string>& environment = {});

}  // namespace lancer::test
