// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/played_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/axis/detail/live_cuts.hpp"

#include "axis/src/follow/coupled_peaks.hpp"

namespace jounce {

// ---- begin and end -------------------------------------------------------------------------------

void PlayedMotion::begin(Base base, const ArmedMotion& begun, std::int64_t tick) noexcept {
  held_ = false;
  ending_ = Ending::none;
  above_.clear();
  if (!moving()) begun_ = begun.tick_or(tick);
  base_ = base;
}

void PlayedMotion::begin_path(const ArmedMotion& begun, double ahead,
                              const MotionNow& now) noexcept {
  begin(Base::path, begun, now.tick);
  path_.begin(*begun.movement(), begun.tick_or(now.tick), requested_rate(now.searches), ahead);
}

void PlayedMotion::begin_live(const ArmedMotion& begun, const MotionNow& now) noexcept {
  begin(Base::live, begun, now.tick);
  live_.begin(*begun.movement(), now.tick);
}

void PlayedMotion::begin_group(std::int64_t tick) noexcept {
  base_ = Base::group;
  begun_ = tick;
  joined_ = true;
}

void PlayedMotion::begin_move(const MotionState& last) noexcept {
  own_.forget_changes();
  above_.clear();
  bare_.state = last;
  base_ = Base::move;
}

void PlayedMotion::rest() noexcept {
  base_ = Base::rest;
  ending_ = Ending::none;
  held_ = false;
  own_.forget_changes();
  above_.clear();
}

bool PlayedMotion::continue_above(const MotionState& from, const Goal& goal, bool held,
                                  const MotionNow& now) noexcept {
  base_ = Base::move;
  bare_ = {from, now.tick};
  held_ = held;
  return own_.plan(bare_, goal, requested_rate(now.searches), conditions(now));
}

Movement* PlayedMotion::end_movement() noexcept {
  Movement* const played = movement();
  path_.end();
  live_.end();
  return played;
}

// ---- the rate ------------------------------------------------------------------------------------

double PlayedMotion::requested_rate(bool searches) const noexcept {
  if (held_ || ends()) return 0;
  return searches ? std::min(factor_, 1.0) : factor_;  // a homing has its own velocities
}

bool PlayedMotion::hold(bool on, const MotionNow& now) noexcept {
  const bool before = std::exchange(held_, on);
  if (replan(now)) return true;
  held_ = before;
  return false;
}

bool PlayedMotion::set_factor(double factor, const MotionNow& now) noexcept {
  const double before = std::exchange(factor_, factor);
  if (ends() || !(on_path() || is_move()) || replan(now)) return true;
  factor_ = before;
  return false;
}

/// Applies a new rate: changes that of a path, or plans a move again.
bool PlayedMotion::replan(const MotionNow& now) noexcept {
  return on_path() ? replan_path(now) : replan_move(now);
}

/// The superimposed move comes to rest with the path, and resumes with it.
bool PlayedMotion::replan_path(const MotionNow& now) noexcept {
  SuperimposedMove above = above_;
  if (!above.hold(requested_rate(now.searches) == 0, bare_.tick) ||
      !path_.follow(request(now.tick, now.searches, now.next)))
    return false;
  above_ = above;
  return true;
}

/// Plans the move for another rate. A move that comes to rest absorbs the superimposed move.
bool PlayedMotion::replan_move(const MotionNow& now) noexcept {
  const double rate = requested_rate(now.searches);
  if (rate > 0 || !above_.shifts()) return own_.plan(bare_, own_.goal(), rate, conditions(now));
  Goal both = own_.goal();
  both.value += above_.distance();
  if (!own_.plan({now.last, bare_.tick}, both, rate, conditions(now))) return false;
  bare_.state = now.last;
  above_.clear();
  return true;
}

// ---- the own move --------------------------------------------------------------------------------

MoveConditions PlayedMotion::conditions(const MotionNow& now) const noexcept {
  return {.tick = now.tick,
          .last_tick = now.last_tick,
          .rules = now.rules,
          .searches = now.searches,
          .positive_switch = now.positive_switch,
          .negative_switch = now.negative_switch,
          .factor = factor_,
          .rate = requested_rate(now.searches),
          .stopping = ends(),
          .added = above_.running(),
          .shifted = above_.shifts(),
          .shift = above_.finished()};
}

bool PlayedMotion::plan(const Goal& goal, double factor, const MotionNow& now) noexcept {
  return own_.plan({now.last, moving() ? bare_.tick : now.tick}, goal, factor, conditions(now));
}

std::optional<Refusal> PlayedMotion::buffer(const BufferedMove& move,
                                            const MotionNow& now) noexcept {
  if (is_live() && !own_.waiting().full()) return Refusal{Cause::synchronized};
  return own_.buffer(move, expected_end(now.last.position), now.last, planned(), conditions(now));
}

std::optional<Refusal> PlayedMotion::change(const command::ChangeVelocity& what,
                                            const MotionNow& now) noexcept {
  if (ends()) return Refusal{Cause::halting};
  if (!is_move()) return Refusal{Cause::not_a_move};
  return own_.change(what, bare_, conditions(now));
}

/// Counts from the target of the present move, if it has one.
double PlayedMotion::additive_start(double position) const noexcept {
  const bool aimed = is_move() && own_.goal().kind != Goal::Kind::velocity;
  return aimed ? own_.goal().value + above_.finished() : position;
}

// ---- a move and a phase shift on top -------------------------------------------------------------

std::optional<Refusal> PlayedMotion::superimpose(double distance, const MoveDynamics& dynamics,
                                                 const MotionNow& now) noexcept {
  if (on_path() && !path_.steady(now.tick)) return Refusal{.cause = Cause::rate_changing};
  if (path_.swaps() || passes()) return Refusal{.cause = Cause::in_motion};
  if (cuts() != nullptr) return Refusal{.cause = Cause::in_cut_plan};
  const auto end = expected_end(now.last.position);
  auto no = above_.begin(now.tick, distance, dynamics, beneath(now),
                         end ? std::optional(end->position) : std::nullopt);
  // For a move, the refusal names the one of the two that is used up.
  constexpr double either = 2, acceleration = 4, deceleration = 5;
  const MoveDynamics& own = own_.goal().dynamics;
  if (no && no->cause == Cause::no_reserve && no->where == either && is_move() &&
      own.acceleration != own.deceleration) {
    if (no->value == own.acceleration) no->where = acceleration;
    if (no->value == own.deceleration) no->where = deceleration;
  }
  return no;
}

/// The greatest magnitudes of the motion below a superimposed move. Behind a live master, these are
/// the magnitudes that the axis needs anywhere on its cam, for the present motion of the master.
Peaks PlayedMotion::beneath(const MotionNow& now) const noexcept {
  if (on_path()) return path_.peaks_at_rate();
  if (is_move()) return own_.player().peaks_up_to(factor_);
  const Peaks ramp = live_->peaks();
  const Peaks phase = live_.phase().peaks(now.tick);
  const auto& [p, v, a] = bare_.state;
  const Jet& x = now.moment.master;
  const Peaks cam =
      coupled_peaks(live_->slopes(), {std::abs(x[1]), std::abs(x[2]), std::abs(x[3])});
  return {std::max(std::abs(v), cam.velocity) + phase.velocity,
          std::max(std::abs(a), cam.acceleration + ramp.acceleration) + phase.acceleration,
          cam.jerk + ramp.jerk + phase.jerk};
}

std::optional<Refusal> PlayedMotion::shift_phase(double target, const MoveDynamics& dynamics,
                                                 const MotionNow& now) noexcept {
  if (!is_live()) return Refusal{Cause::no_master_input};
  if (cuts() != nullptr) return Refusal{Cause::in_cut_plan};
  if (!std::isfinite(target)) return Refusal{Cause::no_value, target};
  const Peaks engaging = live_->peaks();
  const Peaks above = above_.peaks();
  const PhaseBase base{live_->slopes(),
                       now.moment.master,
                       {.velocity = engaging.velocity + above.velocity,
                        .acceleration = engaging.acceleration + above.acceleration,
                        .jerk = engaging.jerk + above.jerk}};
  return live_.phase().begin(now.tick, target, dynamics, base, config_);
}

std::optional<Refusal> PlayedMotion::cut(const command::Cut& what) noexcept {
  if (cuts() == nullptr) return Refusal{Cause::no_cut_plan};
  return cuts()->cut(what, live_.master_shift());
}

std::optional<Refusal> PlayedMotion::park() noexcept {
  if (cuts() == nullptr) return Refusal{Cause::no_cut_plan};
  cuts()->park();
  return std::nullopt;
}

// ---- the setpoint --------------------------------------------------------------------------------

Cause PlayedMotion::advance_live(Setpoint& next, ProfileStep& profile, bool master_moved,
                                 const MotionNow& now) noexcept {
  // A pass that ends exactly in a tick is found in this tick and in the next one; a master may also
  // rest at the end of a pass.
  const double dt = now.moment.dt;
  const auto before = profile.events();
  const double reported = before.empty() ? std::numeric_limits<double>::quiet_NaN()
                                         : before.back().t - dt;  // from this tick
  profile.clear();
  if (const auto end = live_.pass_end(now.moment, now.tick);
      end && master_moved && !(std::abs(end->t - reported) < dt / 2))
    live_.add_pass(*end, now.tick, profile);
  next = live_.at(now.moment, now.tick);
  live_.add_events(now.tick, profile);
  if (live_->progress() != Progress::broken) return Cause::none;
  return is_fault(live_->cause()) ? live_->cause() : Cause::master_lost;
}

std::optional<MotionState> PlayedMotion::expected_end(double position) const noexcept {
  if (!moving()) return MotionState{position, 0, 0};
  const double above = above_.distance();
  if (is_move()) {
    if (own_.repeats()) return std::nullopt;
    const Goal& goal = own_.goal();
    if (goal.kind == Goal::Kind::velocity && goal.value != 0) return std::nullopt;
    const bool there = goal.kind == Goal::Kind::position;
    return MotionState{(there ? goal.value : own_.player().plan().end().position) + above, 0, 0};
  }
  auto end = movement()->end();
  if (end) end->position += above;
  return end;
}

bool PlayedMotion::stands(std::int64_t tick, double velocity) const noexcept {
  return on_path() && !above_.running() && !ends() && path_.rests(tick) && velocity == 0;
}

SupervisedMotion PlayedMotion::supervised(std::int64_t skipped,
                                          const MotionNow& now) const noexcept {
  return {.last = now.last,
          .dt = now.moment.dt,
          .skipped = skipped,
          .path = on_path() ? path_.peaks() : Peaks{},
          .open_ended = path_.open_ended(),
          .joined = joined_,
          .bounded = inside_as_a_whole(now.searches),
          .in_step = in_step(),
          .stops_in_fault = ending_ == Ending::fault,
          .searches = now.searches,
          .positive_switch = now.positive_switch,
          .negative_switch = now.negative_switch};
}

/// Returns true if the whole motion was checked against the position range when it was accepted: a
/// path, or a move to a position. Each can stop inside the range: the path on itself, the move with
/// the stop limits, which exceed those of the move.
bool PlayedMotion::inside_as_a_whole(bool searches) const noexcept {
  if (above_.shifts()) return false;
  if (on_path()) return path_->bounded();
  return is_move() && own_.goal().kind == Goal::Kind::position && requested_rate(searches) > 0;
}

}  // namespace jounce
