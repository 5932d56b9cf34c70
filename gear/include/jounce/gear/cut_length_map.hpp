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

/// The fastest line for each cut length, and the limit that determines it: for a rotary knife, a
/// flying shear, or any cam that can be made for a length.
///
///     const CamOfLength cams = [](double length) -> std::optional<Cam> { ... };
///     const CutLimits limits{{.velocity = 40, .acceleration = 400}, 20};   // slave; line, m/s
///     const auto map = cut_length_map(cams, lengths, limits);
///     map[3].speed, map[3].limit;                                          // 17.2, "acceleration"
///     const auto shortest = shortest_length(cams, limits, 20, 1, 9.42);    // at 20 m/s
///
/// **Exact.** The speed is that of greatest_master_velocity()
/// (jounce/cam/coupling/master_limits.hpp), which does not sample the cam. Lengths are roots, found
/// to 1e-13 of the length, independent of the given grid.
///
/// Units: m for the web (the material), u for the slave, s for time.

/// Makes the cam of one cut of the given length, over this length of the web; nullopt if it is
/// impossible.
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
  /// "line"; "length" if no cam exists; "" if nothing limits it. Some machines have their own
  /// rules: "reversal", "stroke".
  std::string limit = {};
  double where = 0;  ///< m, position on the cam where the limit is reached
};
/// Returns the greatest line speed for a length.
CutSpeed fastest_cut(const CamOfLength& cams, double length, const CutLimits& limits);

/// Computes the speed without a cam, for a shear that is designed anew for every speed.
using CutSpeedOfLength = std::function<CutSpeed(double length)>;

/// fastest_cut() for every length, in their order.
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
/// determines the speed only between two entries is not found.
std::vector<LimitChange> limit_changes(const CutSpeedOfLength& fastest,
                                       std::span<const CutSpeed> map);
std::vector<LimitChange> limit_changes(const CamOfLength& cams, std::span<const CutSpeed> map,
                                       const CutLimits& limits);

/// Lmin: the shortest length in [from, to] that can be cut at `speed` (m/s), provided that all
/// longer lengths in the interval can be cut, too (for a knife: to = its synchronous length).
/// nullopt if `to` cannot be cut.
std::optional<double> shortest_length(const CamOfLength& cams, const CutLimits& limits,
                                      double speed, double from, double to);

}  // namespace jounce
