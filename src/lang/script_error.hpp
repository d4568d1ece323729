#pragma once
// How evaluation ends early. Both are caught in one place, by the session.

#include <exception>

#include "base/diagnostic.hpp"

namespace lancer::lang {

/// The script is wrong. Evaluation adds the calls that it passes on its way out to `diagnostic.trace`.
struct ScriptError : std::exception {
  explicit ScriptError(Diagnostic d) : diagnostic(std::move(d)) {}
  ScriptError(Code code, Span span, std::string message, std::string help = {})
      : diagnostic(error(code, span, std::move(message), std::move(help))) {}
  const char* what() const noexcept override { return diagnostic.message.c_str(); }
  Diagnostic diagnostic;
};

/// The user asked to stop.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

}  // namespace lancer::lang
