// SPDX-License-Identifier: Apache-2.0
#include "cli/common/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "jounce/design/axes.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::cli {

void require_other_file(const std::string& input, const std::string& output,
                        const std::string& option) {
  std::error_code none;  // a missing file is a different file
  if (input != "-" && output != "-" && std::filesystem::equivalent(input, output, none))
    throw InputError(option, output, "is also the input: choose another name");
}

std::string file_of_axis(const std::string& option, const std::string& path,
                         const std::string& axis, std::size_t axes) {
  if (axes == 1 || path.empty()) return path;
  if (path == "-")
    throw InputError(option, "",
                     "is missing: with several axes, each needs a file. -o a.csv writes a-" + axis +
                         ".csv and so on; --axis " + axis + " writes one axis only");
  return jounce::file_of_axis(path, axis);
}

void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options) {
  require_picture_name("--output", path);
  write_figure(path, figure, options);
}

std::FILE* text_stream(std::initializer_list<std::string> files) {
  return std::find(files.begin(), files.end(), "-") == files.end() ? stdout : stderr;
}

}  // namespace jounce::cli
