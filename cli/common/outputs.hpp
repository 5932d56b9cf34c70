// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/plot/picture_file.hpp"

#include "cli/common/verb.hpp"

/// Files that a verb writes. Check them before the long work whose result they will hold.
namespace jounce::cli {

using jounce::require_other_file, jounce::text_stream;
inline void require_other_file(const std::string& input, const std::string& output) {
  require_other_file(input, output, "--output");
}

/// Calls write_figure(), if the picture replaces none of the files that were read; errors name --output.
void write_picture(const std::string& path, const Figure& figure,
                   const std::vector<std::string>& inputs, const SvgOptions& options = {});

}  // namespace jounce::cli
