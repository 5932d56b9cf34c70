// SPDX-License-Identifier: Apache-2.0
#include "cli/common/picture.hpp"

namespace jounce::cli {

void require_picture(const char* option, const std::string& path) {
  require_picture_name(option, path);
}

void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options) {
  require_picture("--output", path);
  write_figure(path, figure, options);
}

}  // namespace jounce::cli
