#include "image/file.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "catch.hpp"

using lancer::image::can_write;
using lancer::image::write_file_atomically;
namespace fs = std::filesystem;

namespace {

/// An empty folder, gone with all that is in it at the end.
class Folder {
 public:
  Folder() : path_((fs::temp_directory_path() / "lancer-test-XXXXXX").string()) {
    REQUIRE(mkdtemp(path_.data()) != nullptr);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::permissions(path_, fs::perms::owner_all, ignored);
    fs::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + '/' + name; }
  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(path_), fs::directory_iterator());
  }

 private:
  std::string path_;
};

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void make(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

unsigned mode_of(const std::string& path) {
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  return status.st_mode & 07777U;
}

/// What `work` returns when run by a user who is not root: permissions do not bind root.
std::string as_plain_user(const std::function<std::string()>& work) {
  if (geteuid() != 0) return work();
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    const std::string text = setresuid(nobody, nobody, nobody) == 0 ? work() : "cannot become nobody";
    const bool sent = ::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  std::string text(4096, '\0');
  const ssize_t length = ::read(ends[0], text.data(), text.size());
  close(ends[0]);
  waitpid(child, nullptr, 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
  return text;
}

std::string both_errors(const std::string& path) {
  return can_write(path).value_or("none") + "\n" + write_file_atomically(path, "new").value_or("none");
}

/// The same line twice: from the check and from the writing.
std::string twice(const std::string& line) { return line + "\n" + line; }

}  // namespace

TEST_CASE("file: a new file has the bytes, and no other file lies beside it", "[file]") {
  const Folder folder;
  const std::string bytes("a\0b\n", 4);
  CHECK_FALSE(can_write(folder / "a.png"));
  CHECK(folder.entries() == 0);
  CHECK_FALSE(write_file_atomically(folder / "a.png", bytes));
  CHECK(read(folder / "a.png") == bytes);
  CHECK(folder.entries() == 1);
}

TEST_CASE("file: a new file's permissions are what the umask leaves", "[file]") {
  const Folder folder;
  const mode_t before = umask(027);
  CHECK_FALSE(write_file_atomically(folder / "a", "x"));
  umask(before);
  CHECK(mode_of(folder / "a") == 0640);
}

TEST_CASE("file: an old file is replaced, not written into, and its permissions stay", "[file]") {
  const Folder folder;
  make(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0604));
  std::ifstream reader(folder / "a", std::ios::binary);
  CHECK_FALSE(can_write(folder / "a"));
  CHECK_FALSE(write_file_atomically(folder / "a", "new"));
  CHECK(read(folder / "a") == "new");
  CHECK(mode_of(folder / "a") == 0604);
  CHECK(folder.entries() == 1);
  // Who had the old one open still reads the old one, whole.
  CHECK(std::string(std::istreambuf_iterator<char>(reader), {}) == "old");
}

TEST_CASE("file: a path without a folder lies where the process stands", "[file]") {
  const Folder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const auto error = write_file_atomically("a", "x");
  fs::current_path(before);
  CHECK_FALSE(error);
  CHECK(read(folder / "a") == "x");
}

TEST_CASE("file: a link stays a link and its target gets the bytes", "[file]") {
  const Folder folder;
  fs::create_directory(folder / "there");
  make(folder / "there/real", "old");
  fs::create_symlink("there/real", folder / "one");
  fs::create_symlink(folder / "one", folder / "two");
  CHECK_FALSE(can_write(folder / "two"));
  CHECK_FALSE(write_file_atomically(folder / "two", "new"));
  CHECK(read(folder / "there/real") == "new");
  CHECK(fs::is_symlink(folder / "one"));
  CHECK(fs::is_symlink(folder / "two"));
  CHECK(folder.entries() == 3);
}

TEST_CASE("file: a link to a file that is not there makes that file", "[file]") {
  const Folder folder;
  fs::create_directory(folder / "there");
  fs::create_symlink("there/real", folder / "link");
  CHECK_FALSE(can_write(folder / "link"));
  CHECK_FALSE(write_file_atomically(folder / "link", "new"));
  CHECK(read(folder / "there/real") == "new");
  CHECK(fs::is_symlink(folder / "link"));
}

TEST_CASE("file: links in a circle are one clear line", "[file]") {
  const Folder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  CHECK(both_errors(folder / "a") ==
        twice("cannot write " + folder / "a" + ": too many levels of symbolic links"));
}

TEST_CASE("file: a missing folder is one clear line", "[file]") {
  const Folder folder;
  CHECK(both_errors(folder / "no/a.png") ==
        twice("cannot write " + folder / "no/a.png" + ": there is no folder " + folder / "no"));
}

TEST_CASE("file: a file where a folder should be is one clear line", "[file]") {
  const Folder folder;
  make(folder / "f", "old");
  CHECK(both_errors(folder / "f/a.png") ==
        twice("cannot write " + folder / "f/a.png" + ": " + folder / "f" + " is no folder"));
}

TEST_CASE("file: a folder where the file should be is one clear line", "[file]") {
  const Folder folder;
  CHECK(both_errors(folder.path()) == twice("cannot write " + folder.path() + ": it is a folder"));
  CHECK(both_errors(folder / "new/") ==
        twice("cannot write " + folder / "new/" + ": there is no folder " + folder / "new"));
  CHECK(both_errors("") == twice("cannot write : the name is empty"));
}

TEST_CASE("file: a folder without the right to write is one clear line", "[file]") {
  const Folder folder;
  fs::permissions(folder.path(), fs::perms(0555));
  CHECK(as_plain_user([&] { return both_errors(folder / "a.png"); }) ==
        twice("cannot write " + folder / "a.png" + ": the folder " + folder.path() + ": permission denied"));
  CHECK(folder.entries() == 0);
}

TEST_CASE("file: a write-protected file is not replaced, though its folder would allow it", "[file]") {
  const Folder folder;
  make(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0444));
  fs::permissions(folder.path(), fs::perms(0777));
  CHECK(as_plain_user([&] { return both_errors(folder / "a"); }) ==
        twice("cannot write " + folder / "a" + ": permission denied"));
  CHECK(read(folder / "a") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("file: a full device is one clear line", "[file]") {
  CHECK_FALSE(can_write("/dev/full"));
  CHECK(write_file_atomically("/dev/full", "x") == "cannot write /dev/full: no space left on device");
}

TEST_CASE("file: when the bytes do not fit, the old file stays and nothing is left beside it", "[file]") {
  const Folder folder;
  make(folder / "a", "old");
  // A limit on the size of files stands in for a full disk: both end a write half way.
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  rlimit small = before;
  small.rlim_cur = 10000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  const auto error = write_file_atomically(folder / "a", std::string(50000, 'x'));
  const auto fitting = write_file_atomically(folder / "b", std::string(10000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(error == "cannot write " + folder / "a" + ": file too large");
  CHECK(read(folder / "a") == "old");
  CHECK_FALSE(fitting);
  CHECK(folder.entries() == 2);
}

TEST_CASE("file: a device is written directly and stays a device", "[file]") {
  CHECK_FALSE(can_write("/dev/null"));
  CHECK_FALSE(write_file_atomically("/dev/null", "x"));
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("file: a pipe gets all of the bytes and stays a pipe", "[file]") {
  const Folder folder;
  const std::string path = folder / "pipe";
  REQUIRE(mkfifo(path.c_str(), 0600) == 0);
  const std::string bytes(300000, 'x');
  std::string received;
  std::thread reader([&] { received = read(path); });
  const auto error = write_file_atomically(path, bytes);
  reader.join();
  CHECK_FALSE(error);
  CHECK(received == bytes);
  CHECK(fs::is_fifo(path));
  CHECK(folder.entries() == 1);
}

TEST_CASE("file: a name that someone else's temporary file has is not taken", "[file]") {
  const Folder folder;
  const std::string taken = folder / (".lancer-" + std::to_string(getpid()) + "-0.tmp");
  make(taken, "theirs");
  CHECK_FALSE(write_file_atomically(folder / "a", "new"));
  CHECK(read(taken) == "theirs");
  CHECK(read(folder / "a") == "new");
  CHECK(folder.entries() == 2);
}
