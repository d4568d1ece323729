#pragma once
// Every view of every sample, small.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "session/session.hpp"

namespace lancer::test {

inline constexpr int k_columns = 96;

std::string read_file(const std::filesystem::path& path);

/// As many pixels as k_columns allow.
void make_small(const scene::View& view, tracer::Options& options);

/// Runs every sample, which must say nothing, and visits its views. A view's name is the sample's, with its
/// own behind it where the sample has several.
void each_view(
    const std::function<void(const std::string& name, const session::Session&, const scene::View&)>& visit);

}  // namespace lancer::test
