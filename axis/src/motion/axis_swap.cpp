// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/axis/axis.hpp"

// Changes from one path to the next without a stop: at the end of the present path, or of its pass,
// or where its master passes a position.

namespace jounce {

/// A swap at the end of the path, or of its present pass.
MotionAxis::Rejection MotionAxis::start_at_end() {
  if (base_ == Base::movement && !on_path()) return start_at_pass_end();
  const auto end = expected_end();
  if (!on_path() || !(end || ends_somewhere())) return Refusal{Cause::not_on_path};
  if (end)
    if (auto no = armed_->admit(config_, *end)) return no;
  if (auto no = against_swap()) return no;
  armed_.accept(StartAt::end_of_table, 0, 0, now_.tick);
  change_rate(granted_rate());
  const double s = clock_.at(now_.tick).s;
  const bool repeats = std::isinf(active_->known());
  boundary_ = Boundary::swap;
  boundary_at_ = active_->pass() * (repeats ? std::floor(s / active_->pass()) + 1 : 1);
  if (!end) boundary_at_ = std::numeric_limits<double>::infinity();
  return std::nullopt;
}

/// Another coupling, at the end of a pass of the cam that follows the live master.
MotionAxis::Rejection MotionAxis::start_at_pass_end() {
  if (!active_->passes()) return Refusal{Cause::no_movement};
  if (!armed_.is_live() || above_.running()) return Refusal{Cause::in_motion};
  armed_.accept(StartAt::end_of_table, 0, 0, now_.tick);
  return std::nullopt;
}

/// Rows end with their last row, at rest: its number may not be available yet.
bool MotionAxis::ends_somewhere() const {
  return on_path() && active_->pass() <= 0;
}

/// Sets the boundary of the present path as soon as it is available; until the boundary, rows may
/// be added.
void MotionAxis::seek_boundary() {
  if (boundary_ == Boundary::swap && ends_somewhere() && !active_->growing())
    boundary_at_ = active_->known();
}

/// The present path has reached its boundary. If the boundary was not available at the command,
/// checks now that both paths meet; otherwise the present path ends.
Cause MotionAxis::swap_at_boundary() {
  if (!ends_somewhere()) {
    swap(boundary_at_, *active_->end());
    return Cause::none;
  }
  const Setpoint last = active_->at(moment(boundary_at_));
  if (active_->progress() == Progress::broken) return active_->cause();
  const MotionState end{last.slave[0] + above_.finished(), 0, 0};
  if (const auto no = armed_->admit(config_, end))
    drop(*no);
  else
    swap(boundary_at_, {last.slave[0], 0, 0});
  return Cause::none;
}

/// Reason why the armed movement cannot take over from the present path. From its accepted start to
/// the swap, the rate is limited to the range of both paths. It falls to that by the dynamics of the
/// present path.
MotionAxis::Rejection MotionAxis::against_swap() const {
  if (above_.running() || armed_.is_live()) return Refusal{Cause::in_motion};
  if (!clock_.steady(now_.tick)) return Refusal{Cause::rate_changing};
  return std::nullopt;
}

/// The armed movement continues from the end of the present path, or of its pass, at path time
/// `boundary`.
void MotionAxis::swap(double boundary, MotionState end) {
  boundary_ = Boundary::none;
  if (inputs_.peers == Peers::missing) return drop({.cause = Cause::group_stopped});
  // The boundary may precede the end of the rate change.
  const double rate = clock_.at(now_.tick).rate;
  const double most = armed_->growing() ? 1 : highest_rate(armed_->peaks(), config_);
  if (rate > most * (1 + 1e-9))
    return drop({.cause = Cause::rate_changing, .value = rate, .limit = most});
  end.position += above_.finished();
  if (const Cause no = armed_->begin(end, moment(0)); no != Cause::none)
    return drop({.cause = no, .value = end.position});
  hand_back(active_);
  const ArmedMotion begun = std::exchange(armed_, {});
  active_ = begun.movement();
  group_ = begun.group();
  ++now_.finished;
  joint_ = true;
  above_.clear_finished();
  peaks_ = active_->peaks();
  clock_.shift(boundary);
  shown_ = clock_;
  from_ = now_.tick;
  change_rate(granted_rate());
  state_ = active_->synchronized() ? State::synchronized_motion : State::discrete_motion;
  has_master_ = active_->synchronized();
  outputs_.place(SwitchesOf::master);
}

/// True if the armed movement begins when the master of this path passes a position.
bool MotionAxis::swaps_at_master() const {
  return armed_.waiting() && armed_.when() == StartAt::master_position && active_->synchronized();
}

/// The path time, up to `to`, at which the master passes that position, by bisection. At the end of
/// a pass the master jumps to its beginning: that jump passes nothing.
std::optional<double> MotionAxis::passing(double to) const {
  const auto beyond = [&](double s) { return active_->at(moment(s)).master - armed_.position(); };
  const auto crossing = [&](double low, double high) -> std::optional<double> {
    const double before = beyond(low);
    const double after = beyond(high);
    if (!(before * after <= 0 && before != after)) return std::nullopt;
    if (before == 0) return low;
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      ((beyond(middle) < 0) == (before < 0) ? low : high) = middle;
    }
    return high;
  };
  const double pass = active_->pass();
  const double leap = pass * std::floor(to / pass);
  if (!std::isinf(active_->known()) || !(leap > played_to_)) return crossing(played_to_, to);
  const auto there = crossing(played_to_, std::nextafter(leap, 0));
  return there ? there : crossing(leap, to);
}

/// Swaps there if both paths meet.
void MotionAxis::swap_at_master(double s) {
  const Jet& there = active_->at(moment(s)).slave;
  const MotionState end{there[0], there[1], there[2]};
  if (const auto no = armed_->admit(
          config_, {end.position + above_.finished(), end.velocity, end.acceleration}))
    return drop(*no);
  swap(s, end);
}

}  // namespace jounce
