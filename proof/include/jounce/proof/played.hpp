// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/coupling/coupling.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// One tick of a motion, from the tick log of an axis. Unit u: the unit of the axis.
struct PlayedTick {
  std::int64_t tick = 0;  ///< number of the tick
  double time = 0;        ///< time since the first tick of the motion, s
  double position = 0;    ///< commanded position, u
  double clock = 0;       ///< time since tick 0 of the log, s; the size of this number determines
                          ///< the rounding of `time`
  /// Position of the master, in its unit, if the axis has a live master (column `profile`).
  std::optional<double> master = {};
  /// Correction of the slave by its registration, u, which `position` includes; 0: none.
  double correction = 0;
  bool fault = false;    ///< true: the next tick has a fault, which ended the motion
  std::int64_t job = 0;  ///< number of the motion, column `job`
};

/// Returns the ticks of the last motion in a tick log (TickLog). `csv` is the text of the log,
/// `name` its name for errors. Throws InputError with name, line and key for a text that is not a
/// tick log, or contains no motion.
std::vector<PlayedTick> read_played(const std::string& csv, const std::string& name);

/// A motion as a function of time or of its master.
struct DesignedMotion {
  std::function<Motion(double)> table = {};  ///< the interpolated table
  std::function<double(double)> curve{};     ///< the exact curve, u; empty: there is only a table
};

/// The reference of a motion. Times are in s from its start.
struct Designed {
  DesignedMotion over_time = {};
  /// A cam over its master, for an axis that followed a live master; empty for another axis.
  DesignedMotion over_master{};
  double tolerance = 0;  ///< permitted deviation of the table from the curve, u
  double duration = 0;   ///< duration of the motion, s
  bool cutter =
      false;  ///< true: the spec of a machine that cuts, whose axis may play a plan of cuts
  /// The coupling of the cam. If it starts with a ramp, the comparison leaves the ramp out. A slave
  /// with slave_absolute and slave_period may then be shifted by whole periods, any other slave by any
  /// distance (Played::shift).
  std::optional<CouplingSpec> ramp = {};
};

/// The greatest deviation of the setpoints from a reference.
struct Deviation {
  double error = 0;  ///< greatest deviation, u
  double where = 0;  ///< time since the start, s
  double limit = 0;  ///< permitted deviation, u
};

/// Result of compare_played().
struct Played {
  std::size_t ticks = 0;             ///< number of ticks compared
  std::size_t left_out = 0;          ///< number of ticks before them, which belong to the ramp
  double shift = 0;                  ///< shift of the slave after the ramp, u
  std::int64_t job = 0;              ///< number of the motion in the log
  double start = 0;                  ///< time of the log at which it starts, s
  bool live = false;                 ///< true: compared over the master of the log
  Deviation table{};                 ///< deviation from the table
  std::optional<Deviation> curve{};  ///< deviation from the curve, if the reference has one
  /// Findings:
  /// - "played/table": deviation from the table; the limit is the rounding of the arithmetic.
  /// - "played/curve": deviation from the curve; the limit is the tolerance of the table plus
  ///   rounding.
  /// - "played/gap": greatest number of missing ticks at one place; the limit is a tenth of a
  ///   second. (A late cycle skips some ticks; a log with a gap lacks more.)
  /// - "played/complete": broken if the log ends before the motion; not with a live master.
  /// - "played/fault": a fault ended the motion; only with a live master, whose motion has no end
  ///   of its own.
  Report report = {};
};

/// Compares every tick with the design: over time, or, if the positions do not agree, over the
/// master of the log. The axis may have engaged at the position of the cam, or with master and
/// slave counted from its first tick. Over the master, the comparison subtracts the correction of
/// the slave. If the slave engaged with a ramp, the comparison leaves out the ticks before the first
/// three in a row on the table, at most those within twice the time that the limits of the ramp
/// permit, and throws InputError if fewer than three ticks remain. Requires at least one tick, and in
/// `designed` a table over time, or for ticks with a master, one over the master. The permitted
/// rounding is most_roundings eps (p + v t), with the greatest position p, the greatest velocity v,
/// and the time t of the log. A position is computed from a time, so the rounding of the time shifts
/// the position.
Played compare_played(const std::vector<PlayedTick>& ticks, const Designed& designed);
/// Number of units in the last place that compare_played() permits.
inline constexpr double most_roundings = 32;

}  // namespace jounce
