// Samples cut short, with bytes exchanged, lines doubled and removed: always an outcome, never a crash. The
// full count of cuts runs with LANCER_LONG=1 in the environment.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "catch.hpp"
#include "folder_host.hpp"
#include "fuzz/try_script.hpp"

namespace {

using namespace lancer;

std::vector<std::string> samples() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(LANCER_SAMPLES_FOLDER))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> out;
  test::FolderHost host;
  for (const auto& path : paths) out.push_back(host.read(path.string()).text);
  return out;
}

std::size_t stride() { return std::getenv("LANCER_LONG") != nullptr ? 1 : 7; }

/// A stream of numbers from a fixed hash (SplitMix64: Steele, Lea, Flood, OOPSLA 2014).
class Hashes {
 public:
  explicit Hashes(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t limit) {
    std::uint64_t h = state_ += 0x9E3779B97F4A7C15U;
    h = (h ^ h >> 30) * 0xBF58476D1CE4E5B9U;
    h = (h ^ h >> 27) * 0x94D049BB133111EBU;
    return static_cast<std::size_t>((h ^ h >> 31) % limit);
  }

 private:
  std::uint64_t state_;
};

std::string damaged(std::string text, Hashes& hashes) {
  static const std::string k_bytes = "{}()[]<>\"#,.;=+-*/^%?:\\0159eax_ \n\xFF\xC3";
  static const std::vector<std::string> k_words = {
      "let ",      "fn ",   "for ", " in ",           "return ", "sphere ", "group ",
      "material ", "1e308", "..",   "while true { }", "/*",      "0",       "-1"};
  for (std::size_t edits = 1 + hashes.below(4); edits > 0; --edits) {
    const std::size_t at = hashes.below(text.size());
    switch (hashes.below(4)) {
      case 0: text[at] = k_bytes[hashes.below(k_bytes.size())]; break;
      case 1: text.erase(at, 1 + hashes.below(12)); break;
      case 2: text.insert(at, k_words[hashes.below(k_words.size())]); break;
      default: text.insert(hashes.below(text.size()), text.substr(at, hashes.below(60))); break;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("a sample cut short at any byte is an outcome and not a crash", "[fuzz]") {
  for (const std::string& sample : samples()) {
    for (std::size_t length = 0; length < sample.size(); length += stride()) {
      const session::Outcome outcome = test::try_script(sample.substr(0, length));
      CHECK((outcome == session::Outcome::fine || outcome == session::Outcome::script_wrong));
    }
  }
}

TEST_CASE("a sample with small damages is an outcome and not a crash", "[fuzz]") {
  Hashes hashes(1);
  for (const std::string& sample : samples()) {
    for (std::size_t i = 0; i < 1000 / stride(); ++i) {
      const session::Outcome outcome = test::try_script(damaged(sample, hashes));
      CHECK((outcome == session::Outcome::fine || outcome == session::Outcome::script_wrong));
    }
  }
}
