// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "jounce/path/plan.hpp"

namespace jounce {

/// Place in a plan at a time of the plan, and what remains. u is the axes' unit of length.
struct PlanPlace {
  double position = 0;       ///< u, length along the path from its start
  double remaining = 0;      ///< s, time to the end of the plan
  double look_ahead = 0;     ///< u, distance to the place where the plan brakes for its end
  std::int32_t line = 0;     ///< source line of the present command
  std::size_t commands = 0;  ///< number of commands that have not ended, including the present one
};

/// Reports the progress of a motion along a plan.
///
///     const PlanProgress progress(motion);
///     progress.at(0.5).remaining;                            // s
///
/// Commands with the same source line count as one, and so do lines that the planner has joined.
/// The duration of the constructor is proportional to the number of pieces, the duration of at() to
/// the logarithm of this number.
class PlanProgress {
 public:
  explicit PlanProgress(std::shared_ptr<const Plan> plan);

  /// `t`: time of the plan, s; it is limited to [0, duration].
  [[nodiscard]] PlanPlace at(double t) const;

 private:
  std::shared_ptr<const Plan> plan_;
  double brakes_ = 0;                // q at which the plan brakes for its end
  std::vector<std::uint32_t> left_;  // by piece: commands that have not ended
};

}  // namespace jounce
