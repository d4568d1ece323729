#pragma once
// What `lancer --help` says.

#include <string>

namespace lancer::app {

extern const char* const k_examples;

std::string general_help();

}  // namespace lancer::app
