// SPDX-License-Identifier: Apache-2.0
#include "cli/common/outputs.hpp"

namespace jounce::cli {

void write_picture(const std::string& path, const Figure& figure,
                   const std::vector<std::string>& inputs, const SvgOptions& options) {
  require_picture_name("--output", path);
  require_no_input(inputs, path);
  write_figure(path, figure, options);
}

}  // namespace jounce::cli
