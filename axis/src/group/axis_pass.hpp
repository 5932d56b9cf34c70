// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/movement.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/compensated_sum.hpp"

#include "axis/src/motion/largest_sum.hpp"

namespace jounce {

/// The largest steps of the motion of an axis, from rest to rest: of the position at one instant, and
/// the sums of those of velocity and acceleration within one tick.
struct AxisSteps {
  Jump position, velocity, acceleration;
};

/// One pass over the segments of the motion of an axis, in the order of time: its ranges and its
/// steps. Needs no memory for the segments.
class AxisPass {
 public:
  explicit AxisPass(double tick) : velocity_(tick), acceleration_(tick) {}

  /// Throws InputError like Trajectory for a segment that is not finite.
  void add(const Segment& f);
  /// Returns the greatest magnitudes since the last call.
  Peaks end_section();

  /// Ranges up to the last end of a section.
  [[nodiscard]] const Ranges& ranges() const { return *ranges_; }
  /// No segment may follow.
  [[nodiscard]] AxisSteps steps();

 private:
  void step_to(const Jet& after);

  profiles_detail::CompensatedSum time_;
  std::optional<Ranges> ranges_, section_;
  Jet before_{};  // at the end of the last segment
  bool begun_ = false;
  Jump position_;
  LargestSum velocity_, acceleration_;
};

}  // namespace jounce
