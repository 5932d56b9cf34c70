// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Returns the text of a file in the newest commit of its git repository (HEAD). Throws InputError
/// for a file that is not in a repository or not in its newest commit, and std::system_error if git
/// cannot be run.
std::string committed_text(const std::string& path);

}  // namespace jounce
