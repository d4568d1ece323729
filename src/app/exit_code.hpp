#pragma once
// How the program ends.

namespace lancer::app {

inline constexpr int k_fine = 0;
inline constexpr int k_script_wrong = 1;
inline constexpr int k_command_wrong = 2;
inline constexpr int k_file_trouble = 3;  // a file that cannot be read or written
inline constexpr int k_interrupted = 130;

}  // namespace lancer::app
