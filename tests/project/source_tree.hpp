#pragma once
// The repository's own files, for tests about the repository.

#include <string>
#include <vector>

struct TreeFile {
  std::string path;  // from the top of the tree, such as "src/base/vec.hpp"
  std::string text;
};

/// Every file that belongs to the repository: all but what is built, what git keeps and what editors leave.
std::vector<TreeFile> source_tree();
