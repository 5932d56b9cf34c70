// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// The peak of a derivative of an axis, or another figure, in a given and an optimized spec.
struct PeakChange {
  std::string name = {};  ///< "geo_jerk"; with several axes "x jerk"
  std::string unit = {};
  std::optional<double> given =
      {};                ///< peak in the given spec; nullopt if no curve can be made from it
  double optimized = 0;  ///< peak in the optimized spec
  std::optional<double> limit = {};  ///< limit, if the spec has one
};

/// Returns the peaks of all derivatives of all axes, before and after an optimization. They show
/// the cost of an optimum: without them, a lower peak acceleration may hide a higher jerk that has
/// no limit.
std::vector<PeakChange> peak_changes(const Spec& given, const Spec& optimized);

/// Returns the other figures that differ between the two specs by more than 0.1 %: duration, rms
/// values, the peaks of a cam's slave over time, the fastest master, and the figures of a [drive],
/// which is simulated. key_figures.hpp lists the names. The units are the units of the limits and
/// of the master in the optimized spec. Empty if one of the specs cannot be assessed.
std::vector<PeakChange> other_changes(const Spec& given, const Spec& optimized);
/// Return the peaks as a text table, and as a JSON list with null for a missing number.
std::string peaks_text(const std::vector<PeakChange>& peaks);
std::string peaks_json(const std::vector<PeakChange>& peaks);

/// Returns other_changes() as a table, to follow the table of peaks; "" for an empty list.
std::string others_text(const std::vector<PeakChange>& others);

}  // namespace jounce
