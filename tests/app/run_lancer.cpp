#include "app/run_lancer.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <pty.h>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lancer::test {
namespace {

struct Pipe {
  int read_end = -1, write_end = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

void close_end(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

sigset_t no_signals() {
  sigset_t out;
  sigemptyset(&out);
  return out;
}

/// fork() with SIGINT and SIGTERM held back in the child until it is the program.
pid_t fork_quietly() {
  sigset_t held = no_signals(), before;
  sigaddset(&held, SIGINT);
  sigaddset(&held, SIGTERM);
  sigprocmask(SIG_BLOCK, &held, &before);
  const pid_t process = fork();
  if (process != 0) sigprocmask(SIG_SETMASK, &before, nullptr);
  return process;
}

/// In the child: becomes the program.
[[noreturn]] void become(const std::vector<std::string>& arguments, const Setting& setting) {
  std::vector<char*> words{const_cast<char*>(LANCER_PROGRAM)};
  for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
  words.push_back(nullptr);
  if (!setting.folder.empty() && chdir(setting.folder.c_str()) != 0) _exit(99);
  if (setting.as_nobody && geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(98);
  const rlimit largest{setting.largest_file, setting.largest_file};
  if (setting.largest_file > 0 && setrlimit(RLIMIT_FSIZE, &largest) != 0) _exit(96);
  // The test program's own handlers must not answer a signal that comes early.
  for (const int number : {SIGINT, SIGTERM}) ::signal(number, SIG_DFL);
  const sigset_t none = no_signals();
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execv(LANCER_PROGRAM, words.data());
  _exit(97);
}

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return exit_code_of(status);
}

/// Reads all of some streams at once, so that the program waits for none.
void drain(std::vector<std::pair<int*, std::string*>> streams) {
  std::array<char, 1 << 16> chunk;
  while (!streams.empty()) {
    std::vector<pollfd> waiting;
    for (const auto& [descriptor, text] : streams) waiting.push_back({*descriptor, POLLIN, 0});
    poll(waiting.data(), waiting.size(), -1);
    for (std::size_t i = streams.size(); i-- > 0;) {
      if (waiting[i].revents == 0) continue;
      const ssize_t count = ::read(*streams[i].first, chunk.data(), chunk.size());
      if (count > 0) {
        streams[i].second->append(chunk.data(), static_cast<std::size_t>(count));
      } else {
        close_end(*streams[i].first);
        streams.erase(streams.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
}

}  // namespace

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "lancer-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for a test");
  path_ = std::filesystem::canonical(name);
  std::filesystem::permissions(path_,
                               std::filesystem::perms::others_read | std::filesystem::perms::others_exec,
                               std::filesystem::perm_options::add);
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path(name);
}

std::string Folder::read(const std::string& name) const {
  std::ifstream in(path_ / name, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    out.push_back(entry.path().filename().string());
  std::sort(out.begin(), out.end());
  return out;
}

Result run_program(const std::vector<std::string>& arguments, const Setting& setting) {
  Pipe in = make_pipe(), out = make_pipe(), err = make_pipe();
  const pid_t process = fork_quietly();
  if (process == 0) {
    dup2(in.read_end, STDIN_FILENO);
    const int file = setting.out_path.empty()
                         ? out.write_end
                         : ::open(setting.out_path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(err.write_end, STDERR_FILENO);
    become(arguments, setting);
  }
  close_end(in.read_end);
  close_end(out.write_end);
  close_end(err.write_end);
  // Inputs of tests are short: they fit into the pipe.
  if (::write(in.write_end, setting.input.data(), setting.input.size()) < 0)
    throw std::runtime_error("no input");
  close_end(in.write_end);
  Result result;
  drain({{&out.read_end, &result.out}, {&err.read_end, &result.err}});
  result.exit_code = wait_for(process);
  return result;
}

Running::Running(const std::vector<std::string>& arguments) {
  Pipe in = make_pipe(), out = make_pipe(), err = make_pipe();
  process_ = fork_quietly();
  if (process_ == 0) {
    dup2(in.read_end, STDIN_FILENO);
    dup2(out.write_end, STDOUT_FILENO);
    dup2(err.write_end, STDERR_FILENO);
    become(arguments, {});
  }
  close_end(in.read_end);
  close_end(out.write_end);
  close_end(err.write_end);
  in_ = in.write_end;
  out_ = out.read_end;
  err_ = err.read_end;
}

Running::~Running() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    wait_for(process_);
  }
  close_end(in_);
  close_end(out_);
  close_end(err_);
}

void Running::wait_for_output() {
  std::array<char, 4096> chunk;
  const ssize_t count = ::read(out_, chunk.data(), chunk.size());
  if (count > 0) result_.out.append(chunk.data(), static_cast<std::size_t>(count));
}

void Running::close_output() { close_end(out_); }

void Running::signal(int number) const { kill(process_, number); }

Result Running::wait() {
  std::vector<std::pair<int*, std::string*>> streams{{&err_, &result_.err}};
  if (out_ >= 0) streams.push_back({&out_, &result_.out});
  drain(streams);
  result_.exit_code = wait_for(process_);
  process_ = -1;
  return result_;
}

Result run_on_terminal(const std::vector<std::string>& arguments, bool both,
                       const std::vector<std::string>& environment) {
  int terminal = -1, program_side = -1;
  winsize size{24, 80, 0, 0};
  if (openpty(&terminal, &program_side, nullptr, nullptr, &size) != 0)
    throw std::runtime_error("no terminal");
  const pid_t process = fork_quietly();
  if (process == 0) {
    setenv("TERM", "xterm", 1);
    unsetenv("NO_COLOR");
    for (const std::string& e : environment) putenv(const_cast<char*>(e.c_str()));
    dup2(::open("/dev/null", O_RDWR), STDIN_FILENO);
    dup2(both ? program_side : ::open("/dev/null", O_RDWR), STDOUT_FILENO);
    dup2(program_side, STDERR_FILENO);
    become(arguments, {});
  }
  close_end(program_side);
  Result result;
  drain({{&terminal, &result.err}});
  result.exit_code = wait_for(process);
  return result;
}

}  // namespace lancer::test
