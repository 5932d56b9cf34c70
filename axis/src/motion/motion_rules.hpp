// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/command.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/command/cause.hpp"

#include "axis/src/motion/armed_motion.hpp"
#include "axis/src/motion/played_motion.hpp"

namespace jounce {

/// The rules for changes of the motion that an axis plays. These functions only read. The first ones
/// return nullopt, or the reason to reject a command.

/// Rejects a movement that the axis cannot begin after its motion, and not where it stands either.
std::optional<Refusal> against_arming(const Movement& movement, const PlayedMotion& motion,
                                      const MotionNow& now, const AxisConfig& config) noexcept;

/// Rejects the start of the armed movement by its condition.
std::optional<Refusal> against_start(const command::Start& what, const ArmedMotion& armed,
                                     const PlayedMotion& motion, const MotionNow& now) noexcept;

/// Rejects a start at the end of the motion, or of its present pass.
std::optional<Refusal> against_start_at_end(const ArmedMotion& armed, const PlayedMotion& motion,
                                            const MotionNow& now,
                                            const AxisConfig& config) noexcept;

/// Rejects a take-over from the present path. From its accepted start to the swap, the rate is limited
/// to the range that both paths permit. The present path slows down to that range within its own
/// limits.
std::optional<Refusal> against_swap(const ArmedMotion& armed, const PlayedMotion& motion,
                                    std::int64_t tick) noexcept;

/// Rejects the end of a motion at the end of its present pass or stroke.
std::optional<Refusal> against_finish(const PlayedMotion& motion,
                                      const AxisConfig& config) noexcept;

/// Rejects a longer path for a group.
std::optional<Refusal> against_extension(const command::Extend& what, const PlayedMotion& motion,
                                         std::int64_t tick) noexcept;

/// The event after a setpoint that was output.
enum class Sequel : std::uint8_t {
  goes_on,         ///< the motion goes on
  rests,           ///< the motion has ended: the axis rests
  next,            ///< the first waiting move begins
  keeps_velocity,  ///< a coupling has ended, and the axis keeps its velocity
  brakes,          ///< a coupling has ended, and the axis brakes
};
/// The axis after a setpoint. u is the unit of the axis.
struct SequelInputs {
  std::int64_t tick = 0;       ///< the present tick
  bool searches = false;       ///< a homing is in progress
  double velocity = 0;         ///< present velocity, u/s
  double most_velocity = 0;    ///< limit of the velocity, u/s
  Cause fault = Cause::none;   ///< the latched fault
  Peers peers = Peers::ready;  ///< Inputs::peers
};
/// Returns the event after the last setpoint.
Sequel sequel_of(const PlayedMotion& motion, const SequelInputs& now) noexcept;

/// Returns why a motion that rests has ended: Tick::reason. `fault`: the latched fault.
Cause reason_to_rest(const PlayedMotion& motion, Cause fault) noexcept;

}  // namespace jounce
