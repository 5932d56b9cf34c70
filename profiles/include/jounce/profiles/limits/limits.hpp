// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/rule.hpp"

namespace jounce {

/// Limits of an axis in its unit u: u, u/s, u/s^2, u/s^3. For a Cam, the limits of the three rates
/// are per master unit m: u/m, u/m^2, u/m^3. A limit of a rate is a magnitude > 0. An omitted limit
/// does not apply.
struct Limits {
  std::optional<double> position_min = {};  ///< u
  std::optional<double> position_max = {};  ///< u
  std::optional<double> velocity = {};      ///< u/s; cam: u/m
  std::optional<double> acceleration = {};  ///< u/s^2; cam: u/m^2
  std::optional<double> jerk = {};          ///< u/s^3; cam: u/m^3
};

/// Throws InputError if a limit is not finite, a limit of a rate is not positive, or min > max.
void require_valid(const Limits& limits);

/// Kind of a finding.
enum class Severity {
  required,  ///< a rule that must hold
  warning,   ///< permitted, but perhaps not intended: an overshoot, a step of the acceleration
  note,      ///< a fact: how far a quantity is above a known bound
};

/// One result of a check: a quantity at its worst place, against its limit.
struct Finding {
  Rule rule;             ///< the rule, such as "limit/velocity" or "continuity/position"
  std::string axis;      ///< name of the axis, if several are checked; may be empty
  std::string quantity;  ///< "velocity", "geo_acceleration", "torque", ...
  double where = 0;      ///< time or master position of the place
  double value = 0;      ///< value of the quantity at this place
  double limit = 0;      ///< permitted value, with the sign of `value`
  /// Distance from the value to the limit, as a share of the limit; negative if the rule is broken.
  /// For a position it is a share of the permitted travel, or of the curve's stroke if only one end
  /// is limited.
  double margin = 0;
  bool broken = false;                 ///< true: the rule is broken
  std::optional<std::size_t> segment;  ///< index of the curve's segment, from 0
  std::string advice;                  ///< change that is suggested to the user; may be empty
  std::string unit = {};               ///< unit of value and limit; empty: the quantity defines it
  std::string where_unit = {};         ///< unit of `where`; empty: that of the time or the master
  Severity severity = Severity::required;  ///< kind of the finding
  /// False for a step or a figure without a limit; `limit` and `margin` then only order the
  /// findings.
  bool has_limit = true;
};

/// Result of a check. Checks do not print, and do not throw for a finding.
struct Report {
  std::vector<Finding> findings;  ///< in the order of sort()

  /// True if no finding is broken.
  [[nodiscard]] bool ok() const;
  [[nodiscard]] std::size_t broken() const;    ///< number of broken findings
  [[nodiscard]] std::size_t warnings() const;  ///< number of warnings that are not broken
};

/// Orders the findings: broken ones, then warnings, kept rules, and notes; each group by ascending
/// margin.
void sort(Report& report);

/// Compares the exact extrema of a curve with the limits. There is one finding for each segment and
/// each limit that the segment breaks; a peak on a break counts for the segment before the break.
/// For each limit that holds, there is one finding, with the smallest margin of the whole curve.
/// Throws like require_valid().
template <class Over>
Report check(const Curve<Over>& f, const Limits& limits);

/// Checks the continuity of the value and of its derivatives up to this order (0 to 3). For a
/// periodic curve, the joint of its end with its start is included. A step is broken if it exceeds
/// `tolerance` times the range of the derivative; the default 1e-9 permits numbers that were
/// rounded in a file.
template <class Over>
Report check_continuity(const Curve<Over>& f, int order, double tolerance = 1e-9);

}  // namespace jounce
