#include "lang/resolve_unused.hpp"

#include <fmt/format.h>

namespace lancer::lang {

UseGraph::Node UseGraph::add(const Declaration& declaration) {
  nodes_.push_back({declaration, {}, false});
  return static_cast<Node>(nodes_.size() - 1);
}

void UseGraph::mention(Node by, Node what) {
  if (what != k_none) nodes_[by].mentions.push_back(what);
}

void UseGraph::spread() {
  std::vector<Node> reached{k_root};
  nodes_[k_root].used = true;
  while (!reached.empty()) {
    const Node from = reached.back();
    reached.pop_back();
    for (const Node to : nodes_[from].mentions) {
      if (nodes_[to].used) continue;
      nodes_[to].used = true;
      reached.push_back(to);
    }
  }
}

void UseGraph::finish(std::vector<Diagnostic>& diagnostics) {
  spread();
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const Entry& entry = nodes_[i];
    const Declaration& d = entry.declaration;
    if (d.used != nullptr) *d.used = entry.used;
    if (entry.used || d.silent || !nodes_[d.owner].used) continue;
    diagnostics.push_back(
        warning(Code::unused, d.span, fmt::format("nothing uses `{}`, so it is not evaluated", d.id)));
  }
}

void UseGraph::keep_all() {
  for (Entry& entry : nodes_) {
    if (entry.declaration.used != nullptr) *entry.declaration.used = true;
  }
}

}  // namespace lancer::lang
