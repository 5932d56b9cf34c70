// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "jounce/design/detail/cut_lengths.hpp"

namespace jounce {

/// The fastest line of a knife or a shear for each cut length, with the limit that determines it.
struct CutMap {
  Spec spec = {};
  CutLengths cuts = {};
  CutLimits limits = {};
  std::vector<CutSpeed> speeds = {};  ///< in ascending order of the length
  /// Lengths at which another limit begins to determine the speed.
  std::vector<LimitChange> changes = {};
  /// Speed of the line: the lower of the speed of [master] and the greatest speed of the line;
  /// without [master], the greatest speed.
  double running = 0;
  /// Shortest cut at the speed `running`, master unit; nullopt if no cut is possible.
  std::optional<double> shortest = {};
  double per_minute = 60;  ///< factor that converts cuts per unit of time to cuts per minute

  /// Unit of a line speed, such as "mm/s".
  [[nodiscard]] std::string speed_unit() const;
};

/// Returns the limits of the cuts: [limits.slave], and the greatest speed of the line. The greatest
/// speed is `line_speed` if given, otherwise the speed of [master], otherwise infinite. Throws
/// InputError, with the place in the document, if nothing would limit the speed.
CutLimits cut_limits(const Spec& spec, const std::optional<double>& line_speed);

/// Returns the map at `steps` equally spaced lengths from `from` to `to` (master unit), both
/// included. Requires steps >= 2 and 0 < from < to.
CutMap cut_map(Spec spec, CutLengths cuts, const CutLimits& limits, double from, double to,
               std::size_t steps);

/// The range of a map, as texts such as "100 mm"; "": chosen for the spec.
struct CutMapTexts {
  std::string from = {}, to = {};  ///< shortest and longest cut
  std::string line_speed = {};     ///< see cut_limits()
  std::size_t steps = 91;          ///< number of lengths
};

/// Returns the map of the spec in a file. Throws InputError with the names of the members of
/// CutMapTexts.
CutMap cut_map(const std::string& path, const CutMapTexts& texts);

/// Returns the name of a limit for tables and legends; "none" for "".
std::string limit_word(const std::string& limit);

/// Name of the range in which cuts need a dwell that the spec does not permit.
inline constexpr const char* needs_dwell = "reverses: needs dwell";

/// Returns the map as CSV: comments with the special lengths and the changes of the limit, then one
/// line for each length.
std::string to_csv(const CutMap& map);

}  // namespace jounce
