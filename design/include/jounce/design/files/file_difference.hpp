// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce {

/// The axes of two files in pairs (paired_axes() in jounce/design/version.hpp), and their
/// comparisons.
struct FileDifference {
  std::vector<std::pair<Input, Input>> axes;
  std::vector<Comparison> comparisons;  ///< one for each pair

  [[nodiscard]] bool equal() const;
};

/// Compares the axes of two files. `before_path` and `after_path` are the file names, for messages.
/// `tolerance` returns the tolerance for the numbers of an axis with the given labels. With `axis`,
/// only this axis. Throws InputError like paired_axes() and compare().
FileDifference file_difference(std::vector<Input> before, std::vector<Input> after,
                               const std::string& before_path, const std::string& after_path,
                               const std::function<Tolerance(const Labels&)>& tolerance,
                               const std::string& axis = "");

/// Returns the answer of `jounce diff`: for two paths of several axes their durations and lengths,
/// then each comparison.
std::string to_text(const FileDifference& difference);
/// Returns {"equal": ..., ...} for one axis, or {"axes": {...}, "equal": ...} for several; with
/// "path" for two paths of several axes.
std::string to_json(const FileDifference& difference);

}  // namespace jounce
