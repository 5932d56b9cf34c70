// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/picture_file.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/base/file.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

struct Removed {
  std::string folder;
  ~Removed() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
};

void write_png(const std::string& path, const std::string& svg) {
  std::string folder = std::filesystem::temp_directory_path() / "jounce.XXXXXX";
  if (mkdtemp(folder.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot make a temporary folder");
  const Removed removed{folder};
  const std::string source = folder + "/picture.svg";
  const std::string target = folder + "/picture.png";
  write_file(source, svg);
  const std::array<std::string, 6> words{"rsvg-convert", "--zoom=2", "--background-color=white",
                                         "-o",           target,     source};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = const_cast<char*>(words[i].c_str());
  pid_t child = 0;
  int status = -1;
  const int spawned =
      posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ);
  if (spawned == 0) waitpid(child, &status, 0);
  if (spawned != 0)
    throw std::system_error(
        spawned, std::generic_category(),
        "needs rsvg-convert (Debian: librsvg2-bin); write .svg instead, or install it");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::system_error(EIO, std::generic_category(), "rsvg-convert failed");
  write_file(path, read_file(target));
}

}  // namespace

void require_picture_name(const std::string& key, const std::string& path) {
  if (!path.ends_with(".png") && !path.ends_with(".svg") && path != "-")
    throw InputError(key, path, "must end in .svg or .png, or be - for SVG on standard output");
}

void write_svg_file(const std::string& path, const std::string& svg) {
  require_picture_name("path", path);
  if (path.ends_with(".png"))
    write_png(path, svg);
  else
    write_file(path, svg);
}

void write_figure(const std::string& path, const Figure& figure, const SvgOptions& options) {
  write_svg_file(path, svg(figure, options));
}

}  // namespace jounce
