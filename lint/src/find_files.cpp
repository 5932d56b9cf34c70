// SPDX-License-Identifier: Apache-2.0
#include "jounce/lint/find_files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <sstream>
#include <string_view>

#include <fnmatch.h>

#include "jounce/io/gcode.hpp"
#include "jounce/io/table_file.hpp"

namespace jounce {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_of_head = 1U << 16U;  ///< bytes; `jounce = 1` is at the beginning

std::string head_of(const fs::path& path, std::size_t most = most_of_head) {
  std::ifstream file(path, std::ios::binary);
  std::string head(most, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

/// True if a line before the first table begins with the key `jounce`. The rest may be wrong: a check reports it.
bool has_version_key(const std::string& head) {
  std::istringstream lines(head.starts_with("\xEF\xBB\xBF") ? head.substr(3) : head);
  for (std::string line; std::getline(lines, line);) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line[begin] == '#') continue;
    if (line[begin] == '[') return false;
    const std::string_view word = std::string_view(line).substr(begin);
    if (!word.starts_with("jounce")) continue;
    const auto next = word.find_first_not_of(" \t", 6);
    if (next != std::string_view::npos && word[next] == '=') return true;
  }
  return false;
}

bool is_key(const std::string& head) {
  const std::string digits = head.substr(0, head.find_last_not_of(" \t\r\n") + 1);
  return digits.size() == 64 && std::all_of(digits.begin(), digits.end(),
                                            [](unsigned char c) { return std::isxdigit(c) != 0; });
}

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

/// The entries of a folder in the order of the alphabet; none if it cannot be read.
std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
  std::error_code none;
  std::vector<fs::directory_entry> all;
  for (fs::directory_iterator i(folder.empty() ? "." : folder, none), end; !none && i != end;
       i.increment(none))
    all.push_back(*i);
  std::sort(all.begin(), all.end());
  return all;
}

bool is_real_folder(const fs::directory_entry& entry) {
  std::error_code none;
  return entry.is_directory(none) && !entry.is_symlink(none);
}

/// Adds the files in and below a folder for which `belongs` is true.
template <class Belongs>
void walk(const fs::path& folder, std::vector<fs::path>& found, const Belongs& belongs) {
  for (const fs::directory_entry& entry : entries_of(folder)) {
    const fs::path path = folder / entry.path().filename();
    if (is_real_folder(entry)) {
      if (!is_hidden(path)) walk(path, found, belongs);
    } else if (belongs(path.string())) {
      found.push_back(path);
    }
  }
}

/// True for a file that `jounce convert` wrote for a controller: its head has a comment such as
/// "a cam for Galil ECAM, by jounce 0.1.0".
bool is_controller_file(const std::string& path) {
  constexpr std::size_t most = 512;
  constexpr std::string_view writer = " by jounce ";
  std::error_code none;
  if (!fs::is_regular_file(path, none) || is_jounce_file(path)) return false;
  const std::string head = head_of(path, most);
  const std::size_t at = head.find(writer);
  return at != std::string::npos && at + writer.size() < head.size() &&
         std::isdigit(static_cast<unsigned char>(head[at + writer.size()])) != 0;
}

/// The files below a folder that match the parts of a pattern.
void expand(const fs::path& folder, std::span<const std::string> parts,
            std::vector<fs::path>& found) {
  const std::string& part = parts.front();
  const auto rest = parts.subspan(1);
  if (part == "**") {
    expand(folder, rest, found);
    for (const fs::directory_entry& entry : entries_of(folder))
      if (is_real_folder(entry) && !is_hidden(entry.path()))
        expand(folder / entry.path().filename(), parts, found);
    return;
  }
  if (part == "." || part == "..") return expand(folder / part, rest, found);
  for (const fs::directory_entry& entry : entries_of(folder)) {
    const fs::path name = entry.path().filename();
    if (fnmatch(part.c_str(), name.c_str(), FNM_PERIOD) != 0) continue;
    std::error_code none;
    if (rest.empty() && is_jounce_file((folder / name).string()))
      found.push_back(folder / name);
    else if (!rest.empty() && entry.is_directory(none))
      expand(folder / name, rest, found);
  }
}

std::vector<fs::path> matches_of(const std::string& pattern) {
  const fs::path path(pattern);
  std::vector<std::string> parts;
  for (const fs::path& part : path.relative_path())
    if (!part.empty()) parts.push_back(part.string());
  if (!parts.empty() && parts.back() == "**") parts.emplace_back("*");
  std::vector<fs::path> found;
  expand(path.root_path(), parts, found);
  return found;
}

bool is_folder(const std::string& name) {
  std::error_code none;
  return fs::is_directory(name, none);
}

bool is_pattern(const std::string& name) {
  std::error_code none;
  return name.find_first_of("*?[") != std::string::npos && !fs::exists(name, none);
}

/// True if the path is in the folder or below it.
bool is_below(const fs::path& path, const fs::path& folder) {
  std::error_code none;
  const fs::path relative =
      fs::weakly_canonical(path, none).lexically_relative(fs::weakly_canonical(folder, none));
  return !relative.empty() && *relative.begin() != "..";
}

/// True for a file with an ending of G-code programs whose text begins as one.
bool is_gcode_file(const std::string& path) {
  constexpr std::array<std::string_view, 8> endings{".ngc",   ".nc",  ".cnc", ".tap",
                                                    ".gcode", ".din", ".mpf", ".spf"};
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::error_code none;
  return std::find(endings.begin(), endings.end(), ending) != endings.end() &&
         fs::is_regular_file(path, none) && begins_as_gcode(head_of(path));
}

/// The files in and below the folders among the names for which `belongs` is true, each once,
/// without those that are named themselves.
std::vector<std::string> others_in_folders(const std::vector<std::string>& names,
                                           bool (*belongs)(const std::string& path)) {
  std::vector<fs::path> found;
  for (const std::string& name : names)
    if (is_folder(name)) walk(name, found, belongs);
  std::set<std::string> all;
  for (const fs::path& path : found)
    if (std::find(names.begin(), names.end(), path.string()) == names.end())
      all.insert(path.lexically_normal().string());
  return {all.begin(), all.end()};
}

}  // namespace

bool is_jounce_file(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  constexpr std::array<std::string_view, 6> endings{".toml",   ".csv",  ".json",
                                                    ".lcmlog", ".mcap", ".key"};
  std::error_code none;
  if (std::find(endings.begin(), endings.end(), ending) == endings.end() ||
      !fs::is_regular_file(path, none))
    return false;
  const std::string head = head_of(path);
  if (ending == ".toml") return has_version_key(head);
  if (ending == ".csv") return head.starts_with("# jounce table");
  if (ending == ".json")
    return head.starts_with('{') && head.find("\"jounce_table\"") != std::string::npos;
  if (ending != ".key") return is_table(head);
  return is_key(head);
}

std::vector<std::string> controller_files(const std::vector<std::string>& names) {
  return others_in_folders(names, is_controller_file);
}

std::vector<std::string> gcode_files(const std::vector<std::string>& names) {
  return others_in_folders(names, is_gcode_file);
}

bool is_one_file(const std::string& name) {
  return !is_folder(name) && !is_pattern(name);
}

std::vector<std::string> find_files(const std::vector<std::string>& names,
                                    const std::string& except) {
  std::vector<std::string> all;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    std::vector<fs::path> found;
    if (is_folder(name))
      walk(name, found, is_jounce_file);
    else if (is_pattern(name))
      found = matches_of(name);
    else
      found.emplace_back(name);
    for (const fs::path& path : found) {
      if (!except.empty() && !is_one_file(name) && is_below(path, except)) continue;
      const std::string shown = name == "-" ? name : path.lexically_normal().string();
      if (seen.insert(shown).second) all.push_back(shown);
    }
  }
  return all;
}

}  // namespace jounce
