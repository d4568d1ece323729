#include "tracer/tree/split.hpp"

#include <algorithm>
#include <limits>

#include "tracer/tree/bins.hpp"
#include "tracer/tree/tasks.hpp"

namespace lancer::tracer {
namespace {

constexpr std::uint32_t k_chunk = 1U << 15;

std::pair<Range, Range> halves(const References& references, const Range& range) {
  const std::uint32_t middle = range.begin + range.count() / 2;
  Range lower(range.begin, middle), upper(middle, range.end);
  for (std::uint32_t i = range.begin; i < middle; ++i) lower.add(references[i]);
  for (std::uint32_t i = middle; i < range.end; ++i) upper.add(references[i]);
  return {lower, upper};
}

void fill(const References& references, std::uint32_t begin, std::uint32_t end, const Binning& binning,
          Bins& bins) {
  for (std::uint32_t i = begin; i < end; ++i) bins.add(references[i], binning.bins(references[i]));
}

Cut best_cut(const References& references, const Range& range, const Binning& binning) {
  if (range.count() < 2 * k_chunk) {
    Bins bins(binning.count());
    fill(references, range.begin, range.end, binning, bins);
    return bins.best();
  }
  const std::uint32_t chunks = (range.count() + k_chunk - 1) / k_chunk;
  std::vector<Bins> of_chunk(chunks, Bins(binning.count()));
  at_once(chunks, [&](std::size_t chunk) {
    const std::uint32_t begin = range.begin + static_cast<std::uint32_t>(chunk) * k_chunk;
    fill(references, begin, std::min(begin + k_chunk, range.end), binning, of_chunk[chunk]);
  });
  for (std::size_t i = 1; i < chunks; ++i) of_chunk[0].add(of_chunk[i]);
  return of_chunk[0].best();
}

/// What is below the cut goes first.
std::pair<Range, Range> part(References& references, const Range& range, const Binning& binning,
                             const Cut& cut) {
  Range lower(range.begin, range.begin), upper(range.end, range.end);
  while (lower.end < upper.begin) {
    const CellBox box = references[lower.end];
    if (binning.bins(box)[cut.axis] < cut.bin) {
      lower.add(box);
      ++lower.end;
    } else {
      upper.add(box);
      references.swap(lower.end, --upper.begin);
    }
  }
  return {lower, upper};
}

}  // namespace

std::pair<Range, Range> split(References& references, const Range& range, bool in_halves) {
  if (in_halves || range.count() == 2) return halves(references, range);
  const Binning binning(range);
  const Cut cut = best_cut(references, range, binning);
  if (!cut.exists()) return halves(references, range);
  return part(references, range, binning, cut);
}

}  // namespace lancer::tracer
