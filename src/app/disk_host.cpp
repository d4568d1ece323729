#include "app/disk_host.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include "app/console.hpp"

namespace lancer::app {
namespace {

using session::FileText;

// Places in a script are counted in 32 bits.
constexpr std::size_t k_most_bytes = std::size_t{1} << 30;

FileText failed(int code) {
  if (code == ENOENT) return {FileText::Status::missing, {}, "there is no such file"};
  if (code == EISDIR) return {FileText::Status::unreadable, {}, "it is a folder"};
  return {FileText::Status::unreadable, {}, std::generic_category().message(code)};
}

}  // namespace

FileText DiskHost::read_all(int descriptor) {
  FileText out{FileText::Status::read, {}, {}};
  std::array<char, 1 << 16> chunk;
  for (;;) {
    if (interrupt_) throw Stopped{};
    const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
    if (count == 0) return out;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed(errno);
    out.text.append(chunk.data(), static_cast<std::size_t>(count));
    if (out.text.size() > k_most_bytes) return {FileText::Status::unreadable, {}, "it is larger than 1 GB"};
  }
}

FileText DiskHost::read(const std::string& canonical) {
  const int descriptor = ::open(canonical.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return failed(errno);
  struct Closer {
    int descriptor;
    ~Closer() { ::close(descriptor); }
  } closer{descriptor};
  return read_all(descriptor);
}

FileText DiskHost::read_input() { return read_all(STDIN_FILENO); }

std::string DiskHost::canonical(const std::string& path) {
  std::error_code problem;
  const auto resolved = std::filesystem::canonical(path, problem);
  if (!problem) return resolved.string();
  // Pipes are there without a place of their own.
  return std::filesystem::exists(path, problem) ? std::filesystem::absolute(path).lexically_normal().string()
                                                : "";
}

void DiskHost::print(std::string_view text) {
  if (print_) print_(text);
}

}  // namespace lancer::app
