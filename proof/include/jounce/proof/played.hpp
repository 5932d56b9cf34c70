// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// One tick of a motion, from the log of an axis.
struct PlayedTick {
  std::int64_t tick = 0;
  double time = 0;      ///< s, since the motion's first tick
  double position = 0;  ///< commanded, u
  double clock = 0;     ///< s, since the log's tick 0: `time` contains its rounding
};

/// The ticks of the last motion in a tick log (see TickLog), from the log's text. Throws InputError
/// with `name`, line and key for a text that is not a tick log, or has no motion.
std::vector<PlayedTick> read_played(const std::string& csv, const std::string& name);

/// Reference of a motion. Times are s since its start.
struct Designed {
  std::function<Motion(double)> table;    ///< the interpolated table
  std::function<double(double)> curve{};  ///< u, the exact curve; empty: only the table exists
  double tolerance = 0;                   ///< u: permitted deviation of the table from the curve
  double duration = 0;                    ///< s
};

/// Greatest deviation of the setpoints from a reference.
struct Deviation {
  double error = 0;  ///< the greatest, u
  double where = 0;  ///< s since the start
  double limit = 0;  ///< u
};

/// Deviation of the setpoints from the design.
struct Played {
  std::size_t ticks = 0;
  Deviation table{};
  std::optional<Deviation> curve{};  ///< if there is a curve besides the table
  /// "played/table": against the rounding of the arithmetic. "played/curve": against the tolerance
  /// of the table, and that rounding. "played/gap": the most ticks missing in one place, against a
  /// tenth of a second (a late cycle skips some, a log with a gap more). "played/complete": broken
  /// if the log ends before the motion.
  Report report;
};

/// Compares every tick. The rounding is `most_roundings` units in the last place of the greatest
/// position, and of the distance that the fastest tick would travel in the time of the log: a
/// position is computed from a time, and a rounded time shifts it by the velocity.
Played compare_played(const std::vector<PlayedTick>& ticks, const Designed& designed);
inline constexpr double most_roundings = 32;

}  // namespace jounce
