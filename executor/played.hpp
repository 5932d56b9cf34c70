#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "jounce/profiles/limits.hpp"

namespace jounce {

/// One tick of a motion, as the log of an axis has it.
struct PlayedTick {
  std::int64_t tick = 0;
  double time = 0;      ///< s, since the motion's first tick
  double position = 0;  ///< commanded, u
};

/// The ticks of the last motion in a tick log (see TickLog), from the log's text. Throws InputError
/// with `name`, line and key for a text that is no tick log, or one without a motion.
std::vector<PlayedTick> read_played(const std::string& csv, const std::string& name);

/// What a motion should have been.
struct Designed {
  std::function<double(double)> position;  ///< u, at s since its start
  double duration = 0;                     ///< s
  double stroke = 0;                       ///< u, > 0: what an error is measured by
};

/// How far what was commanded lies from what was designed.
struct Played {
  std::size_t ticks = 0;
  double error = 0;  ///< the greatest, u
  double where = 0;  ///< s since the start
  /// "played/position" against `limit`; "played/gap": the most ticks left out in one place, against
  /// a tenth of a second (a late cycle leaves some out, a log with a hole more); "played/complete":
  /// broken where the log ends before the motion does.
  Report report;
};

/// Compares every tick. `limit` is the greatest error, relative to the stroke.
Played compare_played(const std::vector<PlayedTick>& ticks, const Designed& designed,
                      double limit = 1e-9);

}  // namespace jounce
