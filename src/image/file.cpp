#include "image/file.hpp"

#include <array>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace lancer::image {

namespace {

WriteError cannot_write(const std::string& path, std::string_view reason) {
  return fmt::format("cannot write {}: {}", path, reason);
}

std::string reason_of(int error) {
  std::string text = std::generic_category().message(error);
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

/// Where a path leads in the end, and what lies there.
struct Target {
  std::string path;
  bool exists = false;
  struct stat status {};
  bool is_regular_or_new() const { return !exists || S_ISREG(status.st_mode); }
};

/// What the link at `path` points at, relative to where the process stands.
std::optional<std::string> follow(const std::string& path) {
  std::array<char, PATH_MAX> text{};
  const ssize_t length = readlink(path.c_str(), text.data(), text.size());
  if (length < 0) return std::nullopt;
  const std::string target(text.data(), static_cast<std::size_t>(length));
  return target.starts_with('/') ? target : folder_of(path) + '/' + target;
}

/// Follows links, those to a file yet to be made too. Sets `error` where that cannot be done.
Target resolve(const std::string& path, int& error) {
  constexpr int most_links = 40;  // as the kernel does
  Target target{path};
  for (int links = 0; links <= most_links; ++links) {
    if (lstat(target.path.c_str(), &target.status) != 0) {
      if (errno != ENOENT) error = errno;
      return target;
    }
    target.exists = true;
    if (!S_ISLNK(target.status.st_mode)) return target;
    const std::optional<std::string> next = follow(target.path);
    if (!next) break;
    target = Target{*next};
  }
  error = ELOOP;
  return target;
}

/// Why nothing can be made in the target's folder; empty if it can.
std::string folder_trouble(const Target& target) {
  const std::string folder = folder_of(target.path);
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0) {
    return errno == ENOENT ? fmt::format("there is no folder {}", folder) : reason_of(errno);
  }
  if (!S_ISDIR(status.st_mode)) return fmt::format("{} is no folder", folder);
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return fmt::format("the folder {}: {}", folder, reason_of(errno));
  return {};
}

/// Why the target cannot be written; empty if it seems that it can.
std::string trouble(const Target& target, int error) {
  if (error == ENOTDIR) return folder_trouble(target);
  if (error != 0) return reason_of(error);
  if (target.path.empty()) return "the name is empty";
  if (target.exists && S_ISDIR(target.status.st_mode)) return "it is a folder";
  if (target.is_regular_or_new()) {
    if (std::string text = folder_trouble(target); !text.empty()) return text;
    if (target.path.ends_with('/')) return "it is a folder";
  }
  if (target.exists && access(target.path.c_str(), W_OK) != 0) return reason_of(errno);
  return {};
}

/// An open file; `error` is the first thing that went wrong.
class Output {
 public:
  explicit Output(int descriptor) : descriptor_(descriptor), error_(descriptor < 0 ? errno : 0) {}
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() { close(); }

  void write(std::string_view bytes) {
    while (error_ == 0 && !bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written >= 0) {
        bytes.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
  }
  /// Gives the file the owner, where allowed, and the permissions of the one that it replaces.
  void take_over(const struct stat& old) {
    if (error_ != 0) return;
    if (fchown(descriptor_, old.st_uid, old.st_gid) != 0 && errno != EPERM) return keep_errno();
    if (fchmod(descriptor_, old.st_mode & 07777) != 0) keep_errno();
  }
  void flush() {
    if (error_ != 0) return;
    int result = fsync(descriptor_);
    while (result != 0 && errno == EINTR) result = fsync(descriptor_);
    // Some file systems cannot flush, and say so with EINVAL.
    if (result != 0 && errno != EINVAL) keep_errno();
  }
  void close() {
    if (descriptor_ < 0) return;
    // After EINTR the descriptor is gone all the same.
    if (::close(descriptor_) != 0 && errno != EINTR && error_ == 0) keep_errno();
    descriptor_ = -1;
  }
  int error() const { return error_; }

 private:
  void keep_errno() { error_ = errno; }

  int descriptor_;
  int error_;
};

int write_directly(const Target& target, std::string_view bytes) {
  Output output(open(target.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
  output.write(bytes);
  output.close();
  return output.error();
}

/// Opens a new file in the target's folder under a name that nothing has. A new file's permissions are those
/// that the umask leaves; one that will replace another is closed to others until it has that one's.
int open_beside(const Target& target, std::string& name) {
  constexpr int most_tries = 1000;
  const mode_t mode = target.exists ? 0600 : 0666;
  for (int number = 0; number < most_tries; ++number) {
    name = fmt::format("{}/.lancer-{}-{}.tmp", folder_of(target.path), getpid(), number);
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

int replace(const Target& target, std::string_view bytes) {
  std::string name;
  Output output(open_beside(target, name));
  if (output.error() != 0) return output.error();
  output.write(bytes);
  if (target.exists) output.take_over(target.status);
  output.flush();
  output.close();
  int error = output.error();
  if (error == 0 && std::rename(name.c_str(), target.path.c_str()) != 0) error = errno;
  if (error != 0) unlink(name.c_str());
  return error;
}

}  // namespace

std::optional<WriteError> write_file_atomically(const std::string& path, std::string_view bytes) {
  int error = 0;
  const Target target = resolve(path, error);
  if (const std::string reason = trouble(target, error); !reason.empty()) return cannot_write(path, reason);
  error = target.is_regular_or_new() ? replace(target, bytes) : write_directly(target, bytes);
  if (error != 0) return cannot_write(path, reason_of(error));
  return std::nullopt;
}

std::optional<WriteError> can_write(const std::string& path) {
  int error = 0;
  const Target target = resolve(path, error);
  if (const std::string reason = trouble(target, error); !reason.empty()) return cannot_write(path, reason);
  return std::nullopt;
}

}  // namespace lancer::image
