// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/axis/axis.hpp"

// The time of a path (path_clock.hpp): its rate, its end, and the stop before a growing path runs
// out.

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

/// True if the available part of the path is shorter than a stop that begins in the next tick.
bool MotionAxis::starves() const {
  if (wanted_rate() == 0) return false;
  if (active_->progress() == Progress::starving) return true;
  if (!active_->growing()) return false;
  const std::int64_t next = now_.tick + 1;
  const double rest = clock_.at(next).s + clock_.way_to_rest(next, slope_to(0, now_.tick));
  return active_->known() < rest + 1e-3 * seconds(1);  // rounding
}

/// Above full speed, a growing path runs only while its available part suffices to return to full
/// speed and then to rest. A slow supply therefore first slows the path; it is an underrun only at
/// full speed. The path gets the requested rate, or half of the increase, or half of that, if half
/// as much again is available: the margin prevents oscillation.
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

/// True if `times` times the path time is available that a run at `rate` takes to full speed and to
/// rest.
bool MotionAxis::knows(std::int64_t tick, double rate, double times) const {
  const double way = clock_.way_by(tick, rate, slope_to(rate, now_.tick));
  return active_->known() >= clock_.at(tick).s + times * way + 1e-3 * seconds(1);  // rounding
}

// ---- rates -------------------------------------------------------------------------------------

/// The requested rate; a path may grant less.
double MotionAxis::wanted_rate() const {
  if (held_ || ending_ != Ending::none) return 0;
  if (homing_) return std::min(factor_, 1.0);  // the motion behind a switch has its own speeds
  return on_path() ? std::min(factor_, most_rate()) : factor_;
}

/// The highest rate of this path, and of the armed one if a swap is due.
double MotionAxis::most_rate() const {
  const double own = highest_rate(peaks_, config_);
  return armed_.waiting() ? std::min(own, highest_rate(armed_->peaks(), config_)) : own;
}

/// The rate that a path accepts now. Above full speed, govern() sets the rate of a growing path; a
/// path that is about to be swapped for a growing one first returns to full speed.
double MotionAxis::granted(double wanted) const {
  if (!on_path() || wanted <= 1) return wanted;
  if (armed_.waiting() && armed_->growing()) return 1;
  return active_->growing() ? std::clamp(clock_.target(), 1.0, wanted) : wanted;
}

bool MotionAxis::change_rate(double rate) {
  if (rate == clock_.target()) return true;
  if (rate == 0) return stop_on_path();
  return clock_.change(now_.tick, rate, slope_to(rate, now_.tick));
}

/// Stops within the available path. After a late cycle, a stop from now on may end beyond it, and
/// so may a change of this tick. The stop then begins in the last stepped tick, for which starves()
/// has kept enough path.
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

/// The slope of a change to that rate from that tick on.
double MotionAxis::slope_to(double rate, std::int64_t tick) const {
  const double highest = std::max({1.0, clock_.highest(tick), rate});
  return rate_slope(peaks_, config_, highest, above_.peaks());
}

/// Applies a new rate: changes the clock of a path, or plans a move again.
MotionAxis::Rejection MotionAxis::replan() {
  const bool done = on_path() ? replan_path() : replan_move();
  return done ? std::nullopt : Rejection(Refusal{Cause::no_such_move});
}

/// The superimposed move comes to rest with the path, and resumes with it.
bool MotionAxis::replan_path() {
  SuperimposedMove above = above_;
  if (!above.hold(wanted_rate() == 0, emitted_) || !change_rate(granted_rate())) return false;
  above_ = above;
  return true;
}

}  // namespace jounce
