// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace jounce {

/// The build of this library.
struct BuildInfo {
  std::string version{};  ///< "0.1.0"
  std::string commit{};   ///< "" if the sources were not in a git repository of their own
  std::string date{};     ///< date of the commit, "2026-11-26"; "" without a commit
  bool changed = false;   ///< the sources differed from the commit
  std::string compiler{}, build_type{};
  std::vector<std::pair<std::string, std::string>> libraries{};  ///< names and versions
  std::vector<std::pair<std::string, std::string>> options{};    ///< options of CMake
};

/// Returns the build of this library.
const BuildInfo& build_info();

/// The build as lines; the first one is "jounce 0.1.0".
std::string build_text(const BuildInfo& build);
std::string build_json(const BuildInfo& build);

}  // namespace jounce
