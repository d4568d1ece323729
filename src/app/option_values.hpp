#pragma once
// The values of options on the command line, strictly read.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "session/session.hpp"
#include "tracer/options.hpp"

namespace lancer::app {

/// The command line is wrong; what() says how, in one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A whole number in [lowest, highest]. Throws UsageError, naming the `option`.
std::int64_t read_whole(const std::string& option, const std::string& text, std::int64_t lowest,
                        std::int64_t highest);

/// A number in [0.001, 1]: an error in display units.
double read_error(const std::string& text);

/// "640,480", each from 1 to 65536, into columns and rows.
void read_size(const std::string& text, tracer::Options& options);

/// "X0,Y0,X1,Y1", whole, X0 < X1 and Y0 < Y1.
tracer::Region read_region(const std::string& text);

/// "media,tree": all skips but these; "true", as an option without a value is given: none at all.
tracer::Skips read_skips(const std::string& text);

/// "name=value".
session::Define read_define(const std::string& text);

}  // namespace lancer::app
