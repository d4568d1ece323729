#pragma once
// Which `let` and `fn` is used: mentioned for its value by a statement, or by a used `let` or `fn`.

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"

namespace lancer::lang {

/// A graph of declarations and what each mentions. The root stands for the
/// statements of the scripts, which are used as such.
class UseGraph {
 public:
  using Node = std::uint32_t;
  static constexpr Node k_root = 0;
  static constexpr Node k_none = 0xFFFFFFFF;  // of parameters and loop variables, whose use does not matter

  struct Declaration {
    std::string_view id;
    Span span;
    bool* used;   // where the answer goes; may be null
    Node owner;   // the declaration that it stands in, or the root
    bool silent;  // no warning
  };

  UseGraph() : nodes_(1) {}
  Node add(const Declaration& declaration);
  void mention(Node by, Node what);
  /// Fills in `used` of all declarations, and warns of what nothing uses; not of what stands within such.
  void finish(std::vector<Diagnostic>& diagnostics);
  /// Takes all declarations for used.
  void keep_all();

 private:
  struct Entry {
    Declaration declaration{};
    std::vector<Node> mentions;
    bool used = false;
  };
  void spread();
  std::vector<Entry> nodes_;
};

}  // namespace lancer::lang
