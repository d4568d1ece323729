#include "project/source_tree.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace fs = std::filesystem;

std::vector<TreeFile> source_tree() {
  constexpr std::array<std::string_view, 5> foreign{"build", ".git", ".cache", ".vscode", ".idea"};
  const fs::path top(LANCER_SOURCE_FOLDER);
  std::vector<TreeFile> files;
  for (auto entry = fs::recursive_directory_iterator(top); entry != fs::recursive_directory_iterator();
       ++entry) {
    if (entry->is_directory() &&
        std::ranges::find(foreign, entry->path().filename().string()) != foreign.end()) {
      entry.disable_recursion_pending();
    }
    if (!entry->is_regular_file() || entry->is_symlink()) continue;
    std::ifstream in(entry->path(), std::ios::binary);
    files.push_back({entry->path().lexically_relative(top).generic_string(),
                     std::string(std::istreambuf_iterator<char>(in), {})});
  }
  std::ranges::sort(files, {}, &TreeFile::path);
  return files;
}
