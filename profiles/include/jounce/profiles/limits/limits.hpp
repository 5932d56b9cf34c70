// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/rule.hpp"

namespace jounce {

/// Limits of an axis, in its own unit u; an omitted value is not limited. For a Cam the three
/// rates are per master unit: u/m, u/m^2, u/m^3. All rates are magnitudes > 0.
struct Limits {
  std::optional<double> position_min = {};
  std::optional<double> position_max = {};
  std::optional<double> velocity = {};
  std::optional<double> acceleration = {};
  std::optional<double> jerk = {};
};

/// Throws InputError for a limit that is not finite, a rate that is not positive, or min > max.
void require_valid(const Limits& limits);

/// Meaning of a finding that is not broken.
enum class Severity {
  required,  ///< it must hold, and does: the margin is the remainder
  warning,   ///< allowed, but perhaps not meant: an overshoot, a step of the acceleration
  note,      ///< a fact: how far above a known bound a quantity is
};

/// One statement of a check: a quantity at its worst place against its limit.
struct Finding {
  Rule rule;             ///< "limit/velocity", "continuity/position", ...
  std::string axis;      ///< name of the axis, if several are checked; may be empty
  std::string quantity;  ///< "velocity", "geo_acceleration", "torque", ...
  double where = 0;      ///< on the curve's axis
  double value = 0;      ///< value of the curve there
  double limit = 0;      ///< permitted value, with the sign of the value
  /// Margin, as a share of the limit (for a position: of the permitted travel, or of the stroke if
  /// only one end is limited); below 0: broken.
  double margin = 0;
  bool broken = false;
  std::optional<std::size_t> segment;  ///< segment of the curve, zero-based
  std::string advice;                  ///< suggested change; may be empty
  std::string unit = {};        ///< unit of value and limit, if the quantity does not define it
  std::string where_unit = {};  ///< unit of `where`, if it is not the axis of the curve
  Severity severity = Severity::required;
  /// false: a step or a figure that has no limit; `limit` and `margin` then only order the findings.
  bool has_limit = true;
};

/// Result of a check: it never prints, and never throws for a finding.
struct Report {
  std::vector<Finding> findings;  ///< like sort() leaves them

  [[nodiscard]] bool ok() const;
  [[nodiscard]] std::size_t broken() const;
  [[nodiscard]] std::size_t warnings() const;  ///< that are not broken
};

/// Puts the broken findings first, worst first; then the warnings, the kept rules, and the notes,
/// each by margin.
void sort(Report& report);

/// Exact extrema against limits. One finding for each segment and quantity that breaks a limit (a peak
/// on a break counts for the segment before); for
/// a limit that holds, one with the smallest margin of the whole curve.
template <class Over>
Report check(const Curve<Over>& f, const Limits& limits);

/// Continuity up to the `order`th derivative, including the wrap of a curve that wraps. A step
/// counts if it exceeds `tolerance` of that derivative's range: 1e-9 permits rounded input, 0
/// nothing.
template <class Over>
Report check_continuity(const Curve<Over>& f, int order, double tolerance = 1e-9);

}  // namespace jounce
