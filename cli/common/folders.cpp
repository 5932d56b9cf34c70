// SPDX-License-Identifier: Apache-2.0
#include "cli/common/folders.hpp"

#include <filesystem>
#include <system_error>

#include "jounce/profiles/error.hpp"

namespace jounce::cli {

void require_folders(std::initializer_list<AskedOutput> outputs) {
  namespace fs = std::filesystem;
  std::error_code none;  // an error counts as no folder
  for (const auto& [option, path] : outputs) {
    if (path.empty() || path == "-") continue;
    if (fs::is_directory(path, none))
      throw InputError(option, path, "is a folder: name a file in it");
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty() && !fs::is_directory(folder, none))
      throw InputError(option, path,
                       "cannot be written, because the folder " + folder.string() +
                           " does not exist: make it first");
  }
}

}  // namespace jounce::cli
