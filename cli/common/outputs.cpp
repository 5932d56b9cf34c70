// SPDX-License-Identifier: Apache-2.0
#include "cli/common/outputs.hpp"

namespace jounce::cli {

void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options) {
  require_picture_name("--output", path);
  write_figure(path, figure, options);
}

}  // namespace jounce::cli
