// SPDX-License-Identifier: Apache-2.0
#include "cli/common/outputs.hpp"

#include <algorithm>

namespace jounce::cli {

void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options) {
  require_picture_name("--output", path);
  write_figure(path, figure, options);
}

std::FILE* text_stream(std::initializer_list<std::string> files) {
  return std::find(files.begin(), files.end(), "-") == files.end() ? stdout : stderr;
}

}  // namespace jounce::cli
