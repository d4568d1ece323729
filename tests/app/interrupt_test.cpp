#include <chrono>
#include <csignal>
#include <thread>

#include "app/run_lancer.hpp"
#include "catch.hpp"

using namespace lancer;
using test::Result;
using Names = std::vector<std::string>;
using std::chrono::steady_clock;

namespace {

const std::string k_scene =
    "sphere { <0, 0, 0>, 1 material { reflection 0.5 } }\nplane { y, -1 }\nlight { at <3, 3, 3> }\n"
    "view { eye <0, 1, 5> look_at <0, 0, 0> size 200, 150 }\nprint(\"go\")\n";

}  // namespace

TEST_CASE("interrupt: a long render stops at once and leaves the old file whole", "[app][interrupt]") {
  for (const int number : {SIGINT, SIGTERM}) {
    test::Folder f;
    f.write("a.png", "the old picture");
    test::Running running({f.write("a.scn", k_scene), "--size", "4000,4000", "--samples", "4096"});
    running.wait_for_output();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const auto start = steady_clock::now();
    running.signal(number);
    const Result r = running.wait();
    CHECK(steady_clock::now() - start < std::chrono::seconds(20));
    CHECK(r.exit_code == 130);
    CHECK(r.err == "lancer: interrupted\n");
    CHECK(f.read("a.png") == "the old picture");
    CHECK(f.names() == Names{"a.png", "a.scn"});
  }
}

TEST_CASE("interrupt: at any moment the file is the old one or the whole new one", "[app][interrupt]") {
  test::Folder f;
  const std::string scene = f.write("a.scn", k_scene);
  REQUIRE(test::run_program({scene, "--samples", "4"}).exit_code == 0);
  const std::string whole = f.read("a.png");
  for (int i = 0; i < 30; ++i) {
    f.write("a.png", "old");
    test::Running running({scene, "--samples", "4"});
    if (i % 2 == 1) running.wait_for_output();
    std::this_thread::sleep_for(std::chrono::milliseconds(4 * i));
    running.signal(SIGINT);
    const Result r = running.wait();
    CAPTURE(i, r.err);
    const std::string left = f.read("a.png");
    // Before the program can listen, the signal ends it: 128 + 2.
    CHECK((r.exit_code == 130 || r.exit_code == 0));
    CHECK((left == "old" || left == whole));
    if (r.exit_code == 0) CHECK(left == whole);
    CHECK(f.names() == Names{"a.png", "a.scn"});
  }
}

TEST_CASE("interrupt: a script that runs for ever stops", "[app][interrupt]") {
  test::Folder f;
  test::Running running(
      {"check", "--run", "--max-steps", "0",
       f.write("a.scn", "for i in 0..70000 { print(i) }\nlet i = 0\nwhile true { i = i + 1 }\n")});
  running.wait_for_output();
  running.signal(SIGINT);
  const Result r = running.wait();
  CHECK(r.exit_code == 130);
}

TEST_CASE("interrupt: while waiting for a script from standard input", "[app][interrupt]") {
  test::Running running({"-"});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  running.signal(SIGINT);
  const Result r = running.wait();
  CHECK(r.exit_code == 130);
  CHECK(r.out.empty());
}
