// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "jounce/design/cut_lengths.hpp"

namespace jounce {

/// The fastest line of a knife or a shear for each cut length, with the limit that binds.
struct CutMap {
  Spec spec;
  CutLengths cuts;
  CutLimits limits;
  std::vector<CutSpeed> speeds;      ///< ascending by length
  std::vector<LimitChange> changes;  ///< lengths at which another limit binds
  double running = 0;                ///< speed of the line: of [master], or its greatest
  std::optional<double> shortest;    ///< shortest cut at that speed, master unit
  double per_minute = 60;            ///< cuts per minute at one cut per unit of time

  /// Unit of a speed of the line, such as "mm/s".
  [[nodiscard]] std::string speed_unit() const;
};

/// [limits.slave], and the greatest speed of the line: `line_speed`, otherwise that of [master], otherwise infinity.
/// Throws InputError, placed in the document, where nothing would limit the speed.
CutLimits cut_limits(const Spec& spec, const std::optional<double>& line_speed);

/// The map at `steps` >= 2 lengths from `from` to `to` (master unit), both included.
CutMap cut_map(Spec spec, CutLengths cuts, const CutLimits& limits, double from, double to,
               std::size_t steps);

/// Name of a limit in tables and legends: "none" for "".
std::string limit_word(const std::string& limit);

/// Name of the stretch in which cuts need a dwell that the spec does not permit.
inline constexpr const char* needs_dwell = "reverses: needs dwell";

/// A line for each length, after comments with the marked lengths and the changes of the limit.
std::string to_csv(const CutMap& map);

}  // namespace jounce
