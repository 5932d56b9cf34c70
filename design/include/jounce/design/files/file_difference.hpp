// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/comparison.hpp"
#include "jounce/spec/key_changes.hpp"

namespace jounce {

/// The axes of two files, paired by their names, and their comparisons.
struct FileDifference {
  std::vector<std::pair<Input, Input>> axes = {};
  std::vector<Comparison> comparisons = {};  ///< one for each pair
  /// For two specs: the changed keys outside the curves and limits; see take_key_changes().
  std::vector<KeyChange> keys = {};

  [[nodiscard]] bool equal() const;
  /// The files of the first pair.
  [[nodiscard]] std::vector<std::string> files() const;
};

/// Compares two specs key by key, after their axes were compared. Each changed limit that is not in
/// [limits] of an axis becomes a remark of the first comparison: a limit of the slave over time, of
/// the disc, of the load, of the drive. Returns the other changed keys that the comparisons do not
/// cover. The comparisons cover the units and, if a curve differs, the sections that describe
/// curves.
std::vector<KeyChange> take_key_changes(const Spec& before, const Spec& after,
                                        std::vector<Comparison>& comparisons);

/// Returns "differs outside the curve: disc.base_radius 60 mm -> 50 mm; ...". Shows at most eight
/// keys, and counts the others. "" if there are none.
std::string to_text(const std::vector<KeyChange>& keys);

/// Returns "disc.base_radius differs", or "3 keys outside the curve differ"; "" if there are none.
std::string headline_of(const std::vector<KeyChange>& keys);

/// Compares the axes of two files. `before_path` and `after_path` are the file names, for messages.
/// `tolerance` returns the tolerance for the numbers of an axis with the given labels. If `axis` is
/// given, compares only this axis. Throws InputError like paired_axes() and compare().
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
