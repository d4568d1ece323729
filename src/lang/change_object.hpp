#pragma once
// What `modify` makes of one object: a new one with some attributes replaced and more transforms.

#include <vector>

#include "lang/build_object.hpp"

namespace lancer::lang {

/// A copy of `object` in which the given attributes take the place of its own, and of those that belong to
/// another form of its kind; transforms follow those there are. Checked like an object that is built. Throws
/// ScriptError at the value at fault, or at `where`, the statement, for what is missing then.
Ref<Object> change_object(const Object& object, const std::vector<AttributeValues>& changes, Span where,
                          Meter& meter, std::vector<Diagnostic>& warnings);

}  // namespace lancer::lang
