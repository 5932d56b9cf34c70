// SPDX-License-Identifier: Apache-2.0
#include "cli/common/picture.hpp"

namespace jounce::cli {

void require_picture(const char* option, const std::string& path) {
  require_picture_name(option, path);
}

void write_svg(const std::string& path, const std::string& picture) {
  require_picture("--output", path);
  write_svg_file(path, picture);
}

void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options) {
  require_picture("--output", path);
  write_svg(path, svg(figure, options));
}

}  // namespace jounce::cli
