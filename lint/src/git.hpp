// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jounce::lint_detail {

/// Result of a run of git.
struct GitAnswer {
  int status = 0;   ///< exit status
  std::string out;  ///< standard output and error, without the last line end
};

/// Runs git with these arguments, without a shell. `index`: file to use as the index of the
/// repository. Throws std::system_error if git cannot be run.
GitAnswer git(std::vector<std::string> arguments, const std::optional<std::string>& index = {});

}  // namespace jounce::lint_detail
