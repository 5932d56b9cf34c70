// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <string>

#include "cli/common/folders.hpp"

namespace jounce::cli {

/// The stream for the summary of a verb: standard error if one of its files is standard output.
inline std::FILE* text_stream(std::initializer_list<std::string> files) {
  return std::find(files.begin(), files.end(), "-") == files.end() ? stdout : stderr;
}

}  // namespace jounce::cli
