#pragma once
// lancer plan: what a render does, what it leaves out, and why.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/command_line.hpp"
#include "app/console.hpp"
#include "session/session.hpp"

namespace lancer::app {

/// The plan of one view, in words.
struct PlanReport {
  /// A skip.
  struct Line {
    std::string name, verdict;  // verdict: "skipped", "as met", "needed", "off"
    std::string what, why;
  };
  using Counts = std::vector<std::pair<std::string, std::uint64_t>>;  // kind, how many; none that are 0

  std::string file, view;
  std::vector<std::string> other_views;
  int width = 0, height = 0;
  int samples = 0;                 // of each pixel; 0: as many as each needs
  double error = 0;                // asked for; 0: none
  std::uint64_t primary_rays = 0;  // with an error: at the least
  int depth = 0;                   // of rays that go on; 0 where none does
  bool reflects = false, transmits = false;
  std::string shadows;          // "none", "blocked", "filtered"
  std::string structure;        // "list", "tree"
  std::uint64_t things = 0;     // that it holds
  std::uint64_t materials = 0;  // that some shape wears
  Counts shapes, lights;
  std::vector<Line> skips;
};

/// Of view number `view_index` of a scene that was made of `file`.
PlanReport plan_report(const session::Session& session, std::size_t view_index, std::string file,
                       const tracer::Options& options);
std::string to_text(const PlanReport& report);

/// The exit code.
int plan(const PlanCommand& command, const Console& console);

}  // namespace lancer::app
