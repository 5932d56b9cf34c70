// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/motion_rules.hpp"

#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/motion/setpoint_supervision.hpp"

namespace jounce {

std::optional<Refusal> against_arming(const Movement& movement, const PlayedMotion& motion,
                                      const MotionNow& now, const AxisConfig& config) noexcept {
  const PathPlayer& path = motion.path();
  const auto from = motion.expected_end(now.last.position);
  std::optional<Refusal> no;
  if (from || path.open_ended())
    no = movement.admit(config, from.value_or(now.last));
  else if (movement.course() == Course::path)
    no = Refusal{Cause::in_motion};
  if (no && motion.stands(now.tick, now.last.velocity)) no = movement.admit(config, now.last);
  // A swap at a master position, or at the end of rows, checks its start state at the swap.
  if (no && motion.on_path() && (path->synchronized() || path.open_ended()) &&
      (no->cause == Cause::start_position || no->cause == Cause::start_velocity))
    no.reset();
  return no;
}

std::optional<Refusal> against_start(const command::Start& what, const ArmedMotion& armed,
                                     const PlayedMotion& motion, const MotionNow& now) noexcept {
  if (what.when == StartAt::end_of_table && armed.is_live()) return Refusal{Cause::no_movement};
  if (what.when == StartAt::tick && what.tick >= 0 && what.tick < now.tick)
    return Refusal{Cause::too_late, static_cast<double>(what.tick), static_cast<double>(now.tick)};
  if (what.when == StartAt::master_position && !std::isfinite(what.position))
    return Refusal{Cause::no_value, what.position};
  const bool swaps = what.when == StartAt::master_position && motion.on_path();
  const bool rests = !motion.moving() || motion.stands(now.tick, now.last.velocity);
  if (!armed.is_live() && !rests && !swaps) return Refusal{Cause::in_motion};
  return swaps ? against_swap(armed, motion, now.tick) : std::nullopt;
}

std::optional<Refusal> against_start_at_end(const ArmedMotion& armed, const PlayedMotion& motion,
                                            const MotionNow& now,
                                            const AxisConfig& config) noexcept {
  if (motion.is_live()) {
    if (!motion.live()->passes()) return Refusal{Cause::no_movement};
    if (!armed.is_live() || motion.above().running()) return Refusal{Cause::in_motion};
    return std::nullopt;
  }
  const auto end = motion.expected_end(now.last.position);
  if (!motion.on_path() || !(end || motion.path().open_ended())) return Refusal{Cause::not_on_path};
  if (end)
    if (auto no = armed->admit(config, *end)) return no;
  return against_swap(armed, motion, now.tick);
}

std::optional<Refusal> against_swap(const ArmedMotion& armed, const PlayedMotion& motion,
                                    std::int64_t tick) noexcept {
  if (motion.above().running() || armed.is_live()) return Refusal{Cause::in_motion};
  if (!motion.path().steady(tick)) return Refusal{Cause::rate_changing};
  return std::nullopt;
}

std::optional<Refusal> against_finish(const PlayedMotion& motion,
                                      const AxisConfig& config) noexcept {
  if (!motion.on_path() && !motion.own().is_stroke()) return Refusal{Cause::not_on_path};
  if (motion.ends()) return Refusal{Cause::halting};
  if (motion.own().is_stroke() || !motion.path().repeats()) return std::nullopt;
  const auto end = motion.path()->end();
  const double most = joint_step(config);
  if (!end) return Refusal{Cause::no_movement};
  if (std::abs(end->velocity) > most) return Refusal{Cause::end_velocity, end->velocity, most};
  return std::nullopt;
}

std::optional<Refusal> against_extension(const command::Extend& what, const PlayedMotion& motion,
                                         std::int64_t tick) noexcept {
  const PathPlayer& path = motion.path();
  if (!motion.on_path()) return Refusal{Cause::no_movement};
  if (path->parts().empty()) return Refusal{Cause::single_axis};
  if (motion.ends()) return Refusal{Cause::halting};
  const PathTime time = path.time(tick);
  if (!(time.s <= what.until)) return Refusal{Cause::too_late, time.s, what.until};
  const double most = what.movement->highest_rate();
  const bool slower = most < path->highest_rate() * (1 - profiles_detail::rounded_sum);
  const bool keeps = path.steady(tick) && time.rate <= most;
  if (slower && !keeps) return Refusal{Cause::rate_changing};
  return std::nullopt;
}

namespace {

Sequel sequel_of_move(const PlayedMotion& motion, const SequelInputs& now) {
  const OwnMove& own = motion.own();
  if (!own.player().is_over(now.tick)) return Sequel::goes_on;
  if (motion.ends()) return Sequel::rests;
  if (motion.requested_rate(now.searches) == 0 || own.repeats()) return Sequel::goes_on;
  if (own.goal().kind == Goal::Kind::position || own.goal().value == 0) return Sequel::rests;
  return own.waiting().empty() ? Sequel::goes_on : Sequel::next;
}

Sequel sequel_of_coupling(const PlayedMotion& motion, const SequelInputs& now) {
  if (motion.live()->progress() != Progress::done) return Sequel::goes_on;
  const double still = profiles_detail::rounded_input * now.most_velocity;  // rounding
  if (!(std::abs(now.velocity) > still)) return Sequel::rests;
  return motion.live()->keeps_velocity() ? Sequel::keeps_velocity : Sequel::brakes;
}

Sequel sequel_of_path(const PlayedMotion& motion, std::int64_t tick, Cause fault, bool is_group) {
  const PathPlayer& path = motion.path();
  const bool passed = path.finishes() && path.reaches_boundary(tick);
  if (path->progress() == Progress::done || passed) return Sequel::rests;
  const bool resumable =
      motion.ending() == PlayedMotion::Ending::fault && (fault == Cause::underrun || is_group);
  return motion.ends() && path.rests(tick) && !resumable ? Sequel::rests : Sequel::goes_on;
}

}  // namespace

Sequel sequel_of(const PlayedMotion& motion, const SequelInputs& now) noexcept {
  if (motion.is_move()) return sequel_of_move(motion, now);
  if (motion.in_group()) return now.peers == Peers::landing ? Sequel::rests : Sequel::goes_on;
  if (motion.is_live()) return sequel_of_coupling(motion, now);
  return sequel_of_path(motion, now.tick, now.fault, is_of_group(now.peers));
}

Cause reason_to_rest(const PlayedMotion& motion, Cause fault) noexcept {
  switch (motion.ending()) {
    case PlayedMotion::Ending::none:
      return motion.path().finishes() ? Cause::pass_ended : Cause::none;
    case PlayedMotion::Ending::stop:
      return Cause::stopped;
    case PlayedMotion::Ending::release:
      return Cause::released;
    case PlayedMotion::Ending::group:
      return Cause::group_stopped;
    case PlayedMotion::Ending::halt:
      return Cause::halted;
    case PlayedMotion::Ending::table:
      return Cause::end_velocity;
    case PlayedMotion::Ending::fault:
      break;
  }
  return fault;
}

}  // namespace jounce
