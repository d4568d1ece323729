#pragma once
// What can be said of a block before anything runs: unknown, repeated and missing attributes, numbers of
// values, parts of two forms.

#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "lang/ast.hpp"

namespace lancer::lang {

/// Reports at most one mistake of form; not even that where `doubtful`, when another mistake in the block was
/// reported already and more would follow from it.
void check_block(const ast::Block& block, bool doubtful, std::vector<Diagnostic>& diagnostics);
/// The part of it that asks whether the block uses one form of its kind, and all of it.
void check_form(const ast::Block& block, std::vector<Diagnostic>& diagnostics);
/// Whether some form of the kind has both attributes; those that go with every form, and what is no attribute
/// of the kind, go with all.
bool go_together(ast::Kind kind, std::string_view one, std::string_view other);
void check_settings(const ast::Settings& settings, std::vector<Diagnostic>& diagnostics);
/// `modify` does not know the kind of what it changes: any kind's attributes will do.
void check_modify(const ast::Modify& modify, std::vector<Diagnostic>& diagnostics);

}  // namespace lancer::lang
