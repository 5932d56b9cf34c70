// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jounce::lint_detail {

struct GitAnswer {
  int status = 0;
  std::string out;  ///< standard output and error, without the last line end
};

/// Runs git with these arguments, without a shell. `index` replaces the index of the repository. Throws
/// std::system_error if git cannot be run.
GitAnswer git(std::vector<std::string> arguments, const std::optional<std::string>& index = {});

}  // namespace jounce::lint_detail
