#include "each_sample.hpp"

#include <algorithm>

#include "catch.hpp"
#include "folder_host.hpp"

namespace lancer::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> samples() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(LANCER_SAMPLES_FOLDER)) {
    if (entry.path().extension() == ".scn") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

std::string read_file(const fs::path& path) {
  FolderHost host;
  return host.read(path.string()).text;
}

void make_small(const scene::View& view, tracer::Options& options) {
  options.columns = k_columns;
  options.rows = std::max(1, k_columns * view.rows / view.columns);
}

void each_view(
    const std::function<void(const std::string& name, const session::Session&, const scene::View&)>& visit) {
  const std::vector<fs::path> all = samples();
  REQUIRE(all.size() >= 12);
  for (const fs::path& path : all) {
    INFO(path.filename().string());
    FolderHost host;
    session::Session session(host);
    const session::Run run = session.run_file(path.string(), {});
    CHECK(to_text(run.diagnostics, session.sources()) == "");
    REQUIRE(run.outcome == session::Outcome::fine);
    const std::vector<scene::View> views = session.views();
    for (std::size_t i = 0; i < views.size(); ++i) {
      std::string name = path.stem().string();
      if (views.size() > 1) name.append("-").append(session.view_name(i));
      visit(name, session, views[i]);
    }
  }
}

}  // namespace lancer::test
