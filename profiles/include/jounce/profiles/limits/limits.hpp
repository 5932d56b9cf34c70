// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/rule.hpp"

namespace jounce {

/// Limits of an axis, in its unit u. A limit of velocity, acceleration or jerk is a magnitude > 0.
/// The limits of a Cam apply to geo_velocity, geo_acceleration and geo_jerk, whose units are u/m,
/// u/m^2 and u/m^3, where m is the unit of the master. An omitted limit does not apply.
struct Limits {
  std::optional<double> position_min = {};  ///< u
  std::optional<double> position_max = {};  ///< u
  std::optional<double> velocity = {};      ///< u/s; cam: u/m
  std::optional<double> acceleration = {};  ///< u/s^2; cam: u/m^2
  std::optional<double> jerk = {};          ///< u/s^3; cam: u/m^3
};

struct Bounds;

/// Returns the limits as the bounds of a move (moves/move.hpp), equal in both directions. A limit
/// that is not given is no bound.
Bounds bounds_of(const Limits& limits);

/// Returns the bounds of a move as limits for check(). An infinite bound is no limit. Throws
/// InputError if the bounds of velocity, acceleration or jerk differ between the directions,
/// because a limit applies to both; also throws like require_valid().
Limits limits_of(const Bounds& bounds);

/// Throws InputError if a limit is not finite, if the limit of velocity, acceleration or jerk is
/// not positive, or if position_min > position_max.
void require_valid(const Limits& limits);

/// Kind of a finding.
enum class Severity {
  required,  ///< a rule that must be satisfied
  warning,   ///< permitted, but perhaps not intended: an overshoot, a step of the acceleration
  note,      ///< a fact: how far a quantity is above a known bound
};

/// One result of a check: a quantity at its worst place, against its limit.
struct Finding {
  Rule rule = {};             ///< the rule, such as "limit/velocity" or "continuity/position"
  std::string axis = {};      ///< name of the axis, if several are checked; may be empty
  std::string quantity = {};  ///< "velocity", "geo_acceleration", "torque", ...
  double where = 0;           ///< time or master position at which the quantity has its worst value
  double value = 0;           ///< value of the quantity at this position
  double limit = 0;           ///< permitted value; for the negative direction of a rate: negative
  /// Distance from the value to the limit, as a share of the limit; negative if the value is beyond
  /// the limit. For a position, the margin is a share of the permitted travel, or of the curve's
  /// stroke if only one end is limited.
  double margin = 0;
  bool broken = false;                      ///< true: the rule is broken
  std::optional<std::size_t> segment = {};  ///< index of the curve's segment, from 0; empty if the
                                            ///< finding has no segment
  std::string advice = {};                  ///< suggested change; may be empty
  std::string unit = {};  ///< unit of value and limit; empty: the quantity defines it
  /// unit of `where`; empty: the unit of the time or the master
  std::string where_unit = {};
  Severity severity = Severity::required;  ///< kind of the finding
  /// False for a step or a figure without a limit. `limit` and `margin` are then used only to order
  /// the findings.
  bool has_limit = true;
};

/// Result of a check. A check does not print. It returns its results as findings, broken or not,
/// and throws only for invalid arguments.
struct [[nodiscard]] Report {
  std::vector<Finding> findings = {};  ///< in the order of sort()

  /// True if no finding is broken.
  [[nodiscard]] bool ok() const;
  [[nodiscard]] std::size_t broken() const;    ///< number of broken findings
  [[nodiscard]] std::size_t warnings() const;  ///< number of warnings that are not broken
};

/// Orders the findings in groups: broken rules, warnings, satisfied rules, notes. In each group the
/// margins ascend.
void sort(Report& report);

/// Compares the exact extrema of a curve with the limits. Returns one finding for each segment and
/// each limit that the segment breaks (each direction of a rate is one limit); a peak on a break
/// counts for the segment before the break. For each limit that the whole curve satisfies, returns
/// one finding, with the smallest margin. Without limits, the report has no findings and is ok:
/// test that the limits of a file are present before you check with them. Throws like
/// require_valid().
template <class Over>
Report check(const Curve<Over>& f, const Limits& limits);

/// Checks the continuity of the value and of its derivatives up to this order (0 to 3). The steps
/// are the results of largest_jump(): they include the step from the end to the start of a periodic
/// curve, and the steps from and to rest at the ends of a curve with the policy `hold`. A rule is
/// broken if a step exceeds `tolerance` times the stroke of the value (order 0) or the peak
/// magnitude of the derivative (orders 1 to 3), and also exceeds rounding. The default 1e-9 permits
/// the rounding of numbers in a file. Throws InputError for an order that is not from 0 to 3.
template <class Over>
Report check_continuity(const Curve<Over>& f, int order, double tolerance = 1e-9);

}  // namespace jounce
