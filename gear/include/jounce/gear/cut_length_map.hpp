// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// The fastest line for each cut length, and the limit that determines its speed. For a rotary
/// knife, a flying shear, or any cam that can be made for a given length.
///
///     const CamOfLength cams = [](double length) -> std::optional<Cam> { ... };
///     const CutLimits limits{{.velocity = 40, .acceleration = 400}, 20};   // slave; line, m/s
///     const auto map = cut_length_map(cams, lengths, limits);
///     map[3].speed, map[3].limit;                                          // 17.2, "acceleration"
///     const auto shortest = shortest_length(cams, limits, 20, 1, 9.42);    // at 20 m/s
///
/// **Exact.** The speed is the result of greatest_master_velocity()
/// (jounce/cam/coupling/master_limits.hpp), which does not sample the cam. shortest_length() and
/// limit_changes() find lengths as roots, to 1e-13 of the length, independent of the grid of
/// `lengths`.
///
/// Units: m for the web (the material), u for the slave, s for time.

/// Returns the cam of one cut of the given length, over this length of the web; nullopt if no such
/// cam exists.
using CamOfLength = std::function<std::optional<Cam>(double length)>;

/// Limits of a cut.
struct CutLimits {
  Limits slave = {};  ///< u/s, u/s^2, u/s^3: limits of the slave over time
  /// m/s, greatest speed of the line itself; default: no limit.
  double line_speed = std::numeric_limits<double>::infinity();
};

/// The greatest line speed for one length.
struct CutSpeed {
  double length = 0;  ///< m
  double speed = 0;   ///< m/s; 0 if no cam exists, infinite if nothing limits it
  /// The limit that determines the speed: "velocity", "acceleration" or "jerk" of the slave;
  /// "line"; "length" if no cam exists; "" if nothing limits the speed. Some machines add limits of
  /// their own, such as "reversal" and "stroke".
  std::string limit = {};
  double where = 0;  ///< m, position on the cam at which the slave reaches the limit
};
/// Returns the greatest line speed for a length. Throws InputError unless the length and the line
/// speed of the limits are positive, and like greatest_master_velocity() (master_limits.hpp).
CutSpeed fastest_cut(const CamOfLength& cams, double length, const CutLimits& limits);

/// Returns the speed for a length without a given cam: for a shear that is designed anew for every
/// speed.
using CutSpeedOfLength = std::function<CutSpeed(double length)>;

/// Return fastest_cut() for every length, in the order of the lengths.
std::vector<CutSpeed> cut_length_map(const CutSpeedOfLength& fastest,
                                     std::span<const double> lengths);
std::vector<CutSpeed> cut_length_map(const CamOfLength& cams, std::span<const double> lengths,
                                     const CutLimits& limits);

/// A length at which another limit begins to determine the speed.
struct LimitChange {
  double length = 0;        ///< m
  std::string before = {};  ///< limit of shorter lengths
  std::string after = {};   ///< limit of longer lengths
};
/// Returns the changes between successive entries of a map whose limits differ. A limit that
/// determines the speed only between two entries may be missed.
std::vector<LimitChange> limit_changes(const CutSpeedOfLength& fastest,
                                       std::span<const CutSpeed> map);
std::vector<LimitChange> limit_changes(const CamOfLength& cams, std::span<const CutSpeed> map,
                                       const CutLimits& limits);

/// Returns the shortest length (Lmin) in [from, to] that can be cut at `speed` (m/s), provided that
/// all longer lengths in the interval can be cut, too (for a knife: to = its synchronous length).
/// Returns nullopt if `to` cannot be cut.
std::optional<double> shortest_length(const CamOfLength& cams, const CutLimits& limits,
                                      double speed, double from, double to);

}  // namespace jounce
