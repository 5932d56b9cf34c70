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

/// Fastest line for each cut length, and its binding limit: of a rotary knife, a flying
/// shear, or any cam that can be made for a length.
///
///     const CamOfLength cams = [](double length) -> std::optional<Cam> { ... };
///     const CutLimits limits{{.velocity = 40, .acceleration = 400}, 20};   // slave; line, m/s
///     const auto map = cut_length_map(cams, lengths, limits);
///     map[3].speed, map[3].limit;                                          // 17.2, "acceleration"
///     const auto shortest = shortest_length(cams, limits, 20, 1, 9.42);    // at 20 m/s
///
/// **Exact.** A speed is that of greatest_master_velocity (jounce/cam/coupling/master_limits.hpp): nothing is
/// sampled over the cam. Lengths are found by roots, to 1e-13 of themselves, and not from the grid.
///
/// m: unit of the web; u: of the slave; s: of time.

/// Returns the cam of one cut of that length, over one length of the web; nullopt if it is
/// impossible.
using CamOfLength = std::function<std::optional<Cam>(double length)>;

struct CutLimits {
  Limits slave = {};  ///< velocity, acceleration, jerk over time
  double line_speed = std::numeric_limits<double>::infinity();  ///< m/s that the line itself does
};

/// The greatest line speed at one length.
struct CutSpeed {
  double length = 0;  ///< m
  double speed = 0;   ///< m/s; 0 without a cam, infinite without a limit
  /// "velocity", "acceleration", "jerk" of the slave; "line"; "length" without a cam; "" without a
  /// limit. Some kinds add their own rules: "reversal", "stroke".
  std::string limit = {};
  double where = 0;  ///< m: the place of the cam at which it is met
};
CutSpeed fastest_cut(const CamOfLength& cams, double length, const CutLimits& limits);

/// The same without a cam, for a shear that is designed for every speed.
using CutSpeedOfLength = std::function<CutSpeed(double length)>;

/// The same for every length, in their order.
std::vector<CutSpeed> cut_length_map(const CutSpeedOfLength& fastest,
                                     std::span<const double> lengths);
std::vector<CutSpeed> cut_length_map(const CamOfLength& cams, std::span<const double> lengths,
                                     const CutLimits& limits);

/// A length at which another limit takes over.
struct LimitChange {
  double length = 0;
  std::string before = {};
  std::string after = {};
};
/// Between the map's neighbors whose limits differ; a limit that comes and goes between two of them
/// is not seen.
std::vector<LimitChange> limit_changes(const CutSpeedOfLength& fastest,
                                       std::span<const CutSpeed> map);
std::vector<LimitChange> limit_changes(const CamOfLength& cams, std::span<const CutSpeed> map,
                                       const CutLimits& limits);

/// Lmin: the shortest length in [from, to] that can be cut at `speed`, if every longer one in the
/// interval can be cut, too (for a knife: to = its synchronous length). nullopt if not even `to`
/// can.
std::optional<double> shortest_length(const CamOfLength& cams, const CutLimits& limits,
                                      double speed, double from, double to);

}  // namespace jounce
