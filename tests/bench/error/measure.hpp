#pragma once
// How far a picture is from the truth: a picture of very many samples.

#include <string>
#include <vector>

#include "image/image.hpp"
#include "session/session.hpp"

namespace lancer::bench {

/// A view of a script, of some size, and how it should look.
struct Subject {
  std::string name;  // of the script, and of the view where there are several, and the size
  int columns = 0, rows = 0;
  image::Image truth;
};

/// The samples a pixel of the truth.
inline constexpr int k_true_samples = 4096;

/// The view at that width, as high as its shape wants. The truth is read from NAME.pfm in the folder, or
/// rendered, which may take minutes, and kept there.
Subject subject(const session::Session& session, const std::string& script, std::size_t view, int columns,
                const std::string& folder);

/// The errors of a picture, in display units (0 to 1: exposed, clamped, sRGB-encoded) but for `linear`. A
/// pixel counts with its worst channel.
struct Errors {
  std::vector<double> pixels;  // of each, in reading order
  double mean_square = 0;      // over all pixels and channels, its root
  double linear = 0;           // the same, linear light clamped to [0, 1]

  /// The share of the pixels that are off by no more than this.
  double share_within(double error) const;
  /// What that share of the pixels is within.
  double quantile(double share) const;
};

Errors errors(const image::Image& picture, const image::Image& truth, double exposure);

}  // namespace lancer::bench
