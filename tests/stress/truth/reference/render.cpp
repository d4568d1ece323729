// lancer-reference-render FILE.scn OUT.pfm: the true picture of a script's first view, and, where asked for,
// a mask of the pixels whose truth hangs on no more than rounding. For comparing ray tracers with.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <tbb/parallel_for.h>

#include "folder_host.hpp"
#include "picture.hpp"
#include "session/session.hpp"

namespace lancer::reference {
namespace {

struct Result {
  int columns = 0, rows = 0;
  std::vector<Color> pixels;          // rows from the top
  std::vector<unsigned char> counts;  // 255: the pixel counts
};

struct Wish {
  std::string script, picture, mask;
  double limit = 1e-7;
  int columns = 0, rows = 0;
  double x = 0.5, y = 0.5;
  bool reversed = false;
};

Result render(const scene::Scene& scene, const scene::View& view, const Wish& wish) {
  Result out{view.columns, view.rows, {}, {}};
  const auto size = static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows);
  out.pixels.resize(size);
  out.counts.assign(size, 255);
  tbb::parallel_for(0, view.rows, [&](int row) {
    Picture picture(scene, view);
    picture.look_at(wish.x, wish.y);
    for (int column = 0; column < view.columns; ++column) {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(view.columns) +
                      static_cast<std::size_t>(column);
      out.pixels[at] = picture.pixel(column, row);
      if (!wish.mask.empty() && picture.at_edge(column, row, wish.limit)) out.counts[at] = 0;
    }
  });
  return out;
}

/// PFM: rows from the bottom, little-endian floats.
bool write_pfm(const Result& result, const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  out << fmt::format("PF\n{} {}\n-1.0\n", result.columns, result.rows);
  const auto columns = static_cast<std::size_t>(result.columns);
  for (auto row = static_cast<std::size_t>(result.rows); row-- > 0;) {
    for (std::size_t i = 0; i < columns; ++i) {
      const Color& c = result.pixels[row * columns + i];
      for (const double value : {c.r, c.g, c.b}) {
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
        for (unsigned shift = 0; shift < 32; shift += 8) out.put(static_cast<char>((bits >> shift) & 0xFF));
      }
    }
  }
  return out.good();
}

bool write_mask(const Result& result, const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  out << fmt::format("P5\n{} {}\n255\n", result.columns, result.rows);
  for (const unsigned char c : result.counts) out.put(static_cast<char>(c));
  return out.good();
}

int run(int argc, char** argv) {
  CLI::App app{"The true picture of a scene, by a tracer of its own in 50 digits"};
  Wish wish;
  app.add_option("script", wish.script, "A .scn file")->required();
  app.add_option("picture", wish.picture, "The .pfm file to write")->required();
  app.add_option("--mask", wish.mask, "A .pgm file to write: 255 where a pixel counts, 0 at edges");
  app.add_option("--limit", wish.limit, "The error that a pixel is judged by");
  app.add_option("--columns", wish.columns, "In place of the view's");
  app.add_option("--rows", wish.rows, "In place of the view's");
  app.add_option("--pixel-x", wish.x, "Where a pixel is looked at, from its left edge; 0.5 is its centre");
  app.add_option("--pixel-y", wish.y, "Where a pixel is looked at, from its upper edge");
  app.add_flag("--reversed", wish.reversed, "Coincident surfaces show the object that was added last");
  CLI11_PARSE(app, argc, argv);
  test::FolderHost host;
  session::Session session(host);
  const session::Run loaded = session.run_file(wish.script, {});
  if (loaded.outcome != session::Outcome::fine) {
    fmt::print(stderr, "{}{}\n", to_text(loaded.diagnostics, session.sources()), loaded.problem);
    return 1;
  }
  scene::Scene scene = session.scene();
  if (wish.reversed) std::reverse(scene.shapes.begin(), scene.shapes.end());
  scene::View view = session.views().front();
  if (wish.columns > 0) view.columns = wish.columns;
  if (wish.rows > 0) view.rows = wish.rows;
  const Result result = render(scene, view, wish);
  if (!write_pfm(result, wish.picture) || (!wish.mask.empty() && !write_mask(result, wish.mask))) {
    fmt::print(stderr, "cannot write {} or {}\n", wish.picture, wish.mask);
    return 3;
  }
  return 0;
}

}  // namespace
}  // namespace lancer::reference

int main(int argc, char** argv) { return lancer::reference::run(argc, argv); }
