#pragma once
// The parts that the table of built-in functions is put together from. Internal to builtins*.cpp.

#include <span>

#include "lang/builtins.hpp"

namespace lancer::lang {

std::span<const BuiltinInfo> component_builtins();
std::span<const BuiltinInfo> vector_builtins();
std::span<const BuiltinInfo> color_builtins();
std::span<const BuiltinInfo> chance_builtins();
std::span<const BuiltinInfo> list_builtins();
std::span<const BuiltinInfo> string_builtins();
std::span<const BuiltinInfo> other_builtins();

}  // namespace lancer::lang
