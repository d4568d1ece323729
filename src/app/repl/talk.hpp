#pragma once
// One talk with a user: the document, what was set, and where answers go.

#include <string>
#include <string_view>

#include "app/console.hpp"
#include "app/disk_host.hpp"
#include "session/document.hpp"
#include "tracer/options.hpp"

namespace lancer::app {

struct Talk {
  Talk(const Console& c, session::RunOptions run_options);

  /// To standard output.
  void tell(std::string_view text) const;
  /// What came of an entry or change: what it printed, and its messages. Throws Refused where it failed.
  void answer(const session::Reply& reply) const;
  /// Of the view that is drawn unless another is named.
  std::size_t view_index() const;

  const Console& console;
  DiskHost host;
  session::RunOptions run;
  session::Document document;
  tracer::Options options;  // of pictures
  std::string view;         // empty: the first
  std::string saved;        // the text as it was opened or saved last
  std::string path;         // of the file that it belongs to; empty: none
  tracer::Stats stats;      // of the last picture
  bool has_stats = false;
  bool is_over = false;
};

/// An entry failed; why has been said.
struct Refused {};

}  // namespace lancer::app
