// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/axis/axis.hpp"

// The time of a path (path_clock.hpp): how fast it runs, where it ends, and that a path which grows is
// never run out of.

namespace jounce {

Cause MotionAxis::advance_path(Setpoint& next) {
  PathTime time = clock_.at(now_.tick);
  seek_boundary();
  if (boundary_ != Boundary::none && time.s >= boundary_at_) {
    if (boundary_ == Boundary::finish) {
      joint_ = true;
      next = {now_.master, 0, {active_->end()->position, 0, 0, 0}};
      return Cause::none;
    }
    if (const Cause no = swap_at_boundary(); no != Cause::none) return no;
    time = clock_.at(now_.tick);
  }
  govern();
  if (ending_ != Ending::fault && starves()) return Cause::underrun;
  if (active_->growing() && time.s > active_->known()) return Cause::jump;
  next = active_->at(moment(time.s));
  if (const auto s = swaps_at_master() ? passing(time.s) : std::nullopt) {
    swap_at_master(*s);
    time = clock_.at(now_.tick);
    next = active_->at(moment(time.s));
  }
  played_to_ = time.s;
  next = at_rate(next, time);
  joint_ = joint_ || active_->progress() == Progress::done;
  if (active_->progress() != Progress::broken) return Cause::none;
  return is_fault(active_->cause()) ? active_->cause() : Cause::jump;
}

/// Less is known of the path than a stop begun in the next tick would need.
bool MotionAxis::starves() const {
  if (wanted_rate() == 0) return false;
  if (active_->progress() == Progress::starving) return true;
  if (!active_->growing()) return false;
  const std::int64_t next = now_.tick + 1;
  const double rest = clock_.at(next).s + clock_.way_to_rest(next, slope_to(0, now_.tick));
  return active_->known() < rest + 1e-3 * seconds(1);  // rounding
}

/// Above full speed a growing path runs only while it could come back to full speed on what is
/// known, and then to rest: supply that does not keep up makes it slower, and only at full speed is
/// it an underrun. What was asked for, or half the way to it, or half of that, is granted where half
/// as much again is known, so that it does not tremble.
void MotionAxis::govern() {
  if (factor_ <= 1 || wanted_rate() <= 1) return;
  if (!active_->growing()) {
    change_rate(granted_rate());
    return;
  }
  const double rate = clock_.target();
  if (rate > 1 && !knows(now_.tick + 1, 1, 1)) change_rate(1);
  if (rate < 1 || !clock_.steady(now_.tick)) return;
  constexpr double least = 1.0 / 64;
  for (double more = wanted_rate(); more - rate > least; more = (more + rate) / 2)
    if (knows(now_.tick, more, 1.5)) {
      change_rate(more);
      return;
    }
}

/// Whether so many times the way is known that a run at `rate` takes to rest by way of full speed.
bool MotionAxis::knows(std::int64_t tick, double rate, double times) const {
  const double way = clock_.way_by(tick, rate, slope_to(rate, now_.tick));
  return active_->known() >= clock_.at(tick).s + times * way + 1e-3 * seconds(1);  // rounding
}

// ---- rates -------------------------------------------------------------------------------------

/// The rate that is asked for now; a path may grant less.
double MotionAxis::wanted_rate() const {
  if (held_ || ending_ != Ending::none) return 0;
  if (homing_) return std::min(factor_, 1.0);  // the way behind a switch is made for its speeds
  return on_path() ? std::min(factor_, most_rate()) : factor_;
}

/// What this path takes, and the one that it is about to be swapped for.
double MotionAxis::most_rate() const {
  const double own = highest_rate(peaks_, config_);
  return waiting_ && pending_ ? std::min(own, highest_rate(pending_->peaks(), config_)) : own;
}

/// What of it a path takes now: above full speed, one that grows has its rate from govern(), and what
/// is about to be swapped for one comes back to full speed first.
double MotionAxis::granted(double wanted) const {
  if (!on_path() || wanted <= 1) return wanted;
  if (waiting_ && pending_ && pending_->growing()) return 1;
  return active_->growing() ? std::clamp(clock_.target(), 1.0, wanted) : wanted;
}

bool MotionAxis::change_rate(double rate) {
  if (rate == clock_.target()) return true;
  if (rate == 0) return stop_on_path();
  return clock_.change(now_.tick, rate, slope_to(rate, now_.tick));
}

/// To rest, on what is known. After a late cycle a stop from now on may end beyond that, and so may whatever
/// was told in this tick: then it begins where the last tick that was stepped has left it room (starves()).
bool MotionAxis::stop_on_path() {
  PathClock now = clock_;
  const bool can = now.target() == 0 || now.change(now_.tick, 0, slope_to(0, now_.tick));
  const double rest = now.at(now_.tick).s + now.way_to_rest(now_.tick, 0);
  const bool reaches = !active_->growing() || rest <= active_->known();
  if (can && reaches) clock_ = now;
  if (reaches) return can;
  clock_ = shown_;
  return clock_.target() == 0 || clock_.change(from_, 0, slope_to(0, from_));
}

/// How steep a change to that rate from that tick on would be.
double MotionAxis::slope_to(double rate, std::int64_t tick) const {
  const double highest = std::max({1.0, clock_.highest(tick), rate});
  Peaks above;
  if (lifting_)
    above = {*lift_most_.velocity, *lift_most_.acceleration, lift_most_.jerk.value_or(0)};
  return rate_slope(peaks_, config_, highest, above);
}

/// The rate has changed: the path runs at another one, a move is planned anew.
bool MotionAxis::replan() {
  const bool done = on_path() ? replan_path() : replan_move();
  if (!done) refuse(Cause::no_such_move);
  return done;
}

/// Where the path comes to rest, so does what is superimposed on it; and goes on with it.
bool MotionAxis::replan_path() {
  const bool rests = wanted_rate() == 0;
  if (!lifting_ || rests == lift_rests_) return change_rate(granted_rate());
  // Starts from the last setpoint, or in the tick of its command.
  const std::int64_t from = std::max(emitted_, lift_origin_);
  const auto lift = plan_lift(lift_.at(seconds(from - lift_origin_)), lift_goal_, rests ? 0 : 1);
  if (!lift || !change_rate(granted_rate())) return false;
  lift_ = *lift;
  lift_origin_ = from;
  lift_rests_ = rests;
  return true;
}

}  // namespace jounce
