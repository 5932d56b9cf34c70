// SPDX-License-Identifier: Apache-2.0
#include "cli/common/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/profiles/error.hpp"

namespace jounce::cli {

Check ends_in(std::vector<std::string> endings) {
  return [endings = std::move(endings)](const std::string& file) -> std::string {
    const std::string ending = std::filesystem::path(file).extension();
    const bool known = std::find(endings.begin(), endings.end(), ending) != endings.end();
    if (known || ending.empty() || endings.empty()) return "";
    return fmt::format("must end in {}{}", endings.size() > 1 ? "one of " : "",
                       fmt::join(endings, ", "));
  };
}

Check output_file(std::vector<std::string> endings) {
  return [ends = ends_in(std::move(endings))](const std::string& file) -> std::string {
    namespace fs = std::filesystem;
    std::error_code none;  // an error counts as no folder
    if (file == "-") return "";
    if (fs::is_directory(file, none)) return "is a folder: name a file in it";
    const fs::path folder = fs::path(file).parent_path();
    if (folder.empty() || fs::is_directory(folder, none)) return ends(file);
    return "cannot be written, because the folder " + folder.string() +
           " does not exist: make it first";
  };
}

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
  const auto slash = path.find_last_of('/') + 1;  // npos + 1 is 0
  const auto dot = path.find_last_of('.');
  const auto end = dot == std::string::npos || dot <= slash ? path.size() : dot;
  return path.substr(0, end) + "-" + axis + path.substr(end);
}

void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options) {
  require_picture_name("--output", path);
  write_figure(path, figure, options);
}

std::FILE* text_stream(std::initializer_list<std::string> files) {
  return std::find(files.begin(), files.end(), "-") == files.end() ? stdout : stderr;
}

}  // namespace jounce::cli
