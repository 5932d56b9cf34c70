// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/coupling_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"

#include "cam/src/coupling/settle.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

constexpr double near = 1e-9;  // relative to a cam's length: tolerance of its end

MotionState state(const Jet& y) {
  return {y[0], y[1], y[2]};
}

bool ramps(StartMode mode) {
  return mode != StartMode::absolute && mode != StartMode::relative;
}

/// Passed levels X = origin + n * length between two cycles: their number, and the master position
/// of the last one.
struct Crossings {
  double count = 0;  ///< signed
  double level = 0;
};

Crossings ends_between(double origin, double length, const Placement& p, double before,
                       double now) {
  const double n0 = spot(p.at(before), origin, length, true).period;
  const double n1 = spot(p.at(now), origin, length, true).period;
  const double X = origin + (n1 > n0 ? n1 : n1 + 1) * length;
  return {n1 - n0, (X - p.master_offset) / p.master_scaling};
}

int as_int(double count) {
  constexpr double most = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(count, -most, most));
}

/// The end at which a master on its way from X0 to X1 leaves a cam that runs once: 1 at the cam's
/// end, -1 at its start, 0 none. A master leaves when it arrives at an end. If it comes to rest
/// there, rounding is tolerated. If it still moves, it is beyond the end, or at rest, in the next
/// cycle. It may start at an end.
int left_at(const Cam& cam, double X0, double X1, bool rests) {
  const double eps = near * cam.length();
  if (X0 < cam.start() - eps || X0 > cam.end() + eps) return 0;
  const auto leaves = [&](double before, double now) {  // distances to the end, inside > 0
    return now < -eps || (now < before && before > 0 && (now <= 0 || (rests && now <= eps)));
  };
  if (leaves(cam.end() - X0, cam.end() - X1)) return 1;
  return leaves(X0 - cam.start(), X1 - cam.start()) ? -1 : 0;
}

/// The master as its velocity predicts it, without a jump.
Sample expected(const Engaged& e, const Sample& now) {
  Sample calm = now;
  calm.master[0] = e.master[0] + (now.t - e.time) * (e.master[1] + now.master[1]) / 2;
  return calm;
}

bool jumps(const CouplingSpec& spec, const Engaged& e, const Sample& now) {
  if (!spec.master_jump) return false;
  return e.lost || !(std::abs(now.master[0] - expected(e, now).master[0]) <= *spec.master_jump);
}

bool all_finite(const Sample& s) {
  return std::isfinite(s.t) &&
         std::all_of(s.master.begin(), s.master.end(), [](double v) { return std::isfinite(v); });
}

void count_periods(const Coupling& coupling, const Sample& before, const Sample& now,
                   Stepped& out) {
  const Cam& cam = coupling.cam();
  const Crossings ends = ends_between(cam.start(), cam.length(), out.engaged.placement,
                                      before.master[0], now.master[0]);
  out.periods = as_int(ends.count);
  if (out.periods == 0) return;
  const auto at = out.jumped ? std::nullopt : passing(before, now, ends.level);
  // Without a passage in between, the level coincides with one of the samples, to rounding;
  // backwards, with the first.
  const bool first = !out.jumped && std::abs(before.master[0] - ends.level) <=
                                        std::abs(now.master[0] - ends.level);
  out.end_time = at ? at->t : first ? before.t : now.t;
}

/// The slave at the time of `now`, as if its master had not jumped. If the master was lost, the
/// slave is at rest.
Jet carried_on(const Coupling& coupling, const Engaged& engaged, const Sample& now) {
  if (engaged.lost) return {point(coupling, engaged, engaged.master, engaged.time)[0], 0, 0, 0};
  return point(coupling, engaged, expected(engaged, now).master, now.t);
}

void let_go(const Coupling& coupling, const Jet& slave, double at, double now, Stepped& out) {
  out.released = cam_out(slave, at, coupling.spec().jerk);
  out.slave = point(*out.released, now);
}

/// Releases the slave at the end of a cam that runs once.
void leave(const Coupling& coupling, const Engaged& engaged, const Sample& before,
           const Sample& now, int end, Stepped& out) {
  const Placement& p = engaged.placement;
  const double X = end > 0 ? coupling.cam().end() : coupling.cam().start();
  const auto passed =
      out.jumped ? std::nullopt : passing(before, now, (X - p.master_offset) / p.master_scaling);
  const Sample at = passed.value_or(now);
  out.periods = end;
  out.end_time = at.t;
  let_go(
      coupling,
      out.jumped ? carried_on(coupling, engaged, now) : point(coupling, engaged, at.master, at.t),
      at.t, now.t, out);
}

/// Absorbs a jump of the master by a correction. It tries the start mode of the coupling, then a
/// correction over time in either direction. If both are impossible, it releases the slave. The
/// slave never jumps.
void take_up(const Coupling& coupling, const Engaged& engaged, const Sample& now, Stepped& out) {
  const CouplingSpec& spec = coupling.spec();
  const Jet y = carried_on(coupling, engaged, now);
  const auto settled = [&](StartMode start) {
    return cam_detail::settle(coupling, start, engaged.placement, state(y), now.master, now.t);
  };
  Engagement again = settled(spec.start);
  out.status = again.status;
  if (!again && cam_detail::has_numbers(spec, StartMode::ramp_in))
    again = settled(StartMode::ramp_in);
  if (again)
    out.engaged = again.engaged;
  else
    let_go(coupling, y, now.t, now.t, out);
}

}  // namespace

Released cam_out(const Jet& slave, double t, std::optional<double> jerk) {
  Released released{t, Profile({slave[0], slave[1], 0}, 3)};
  if (!jerk || slave[2] == 0) return released;
  const MoveResult move =
      move_velocity(state(slave), slave[1], within(Bounds::none, Bounds::none, *jerk));
  if (move) released.profile = move.profile;
  return released;
}

Jet point(const Released& released, double t) {
  const double after = t - released.t - released.profile.duration();
  if (after < 0) {
    const Motion now = released.profile.at(t - released.t);
    return {now.position, now.velocity, now.acceleration, now.jerk};
  }
  const MotionState& end = released.profile.end();
  return {end.position + after * end.velocity, end.velocity, 0, 0};
}

Stepped step(const Coupling& coupling, const Engaged& engaged, const Sample& now) {
  Stepped out{.engaged = engaged};
  const Sample before{engaged.time, engaged.master};
  if (!all_finite(now)) {
    out.status = CouplingStatus::not_finite;
    out.slave = {point(coupling, engaged, before.master, before.t)[0], 0, 0, 0};
    out.engaged.lost = true;
    return out;
  }
  out.jumped = jumps(coupling.spec(), engaged, now);
  if (coupling.periodic()) {
    count_periods(coupling, before, now, out);
  } else {
    const Placement& p = engaged.placement;
    const int end =
        left_at(coupling.cam(), p.at(before.master[0]), p.at(now.master[0]), now.master[1] == 0);
    if (end != 0) leave(coupling, engaged, before, now, end, out);
  }
  if (out.jumped && !out.released && ramps(coupling.spec().start))
    take_up(coupling, engaged, now, out);
  if (!out.released) out.slave = point(coupling, out.engaged, now.master, now.t);
  out.engaged.lost = false;
  out.engaged.time = now.t;
  out.engaged.master = now.master;
  out.in_sync = !out.released && out.engaged.correction.done(now.t, now.master[0]);
  // A finished correction stays finished: a master that returns does not restore it.
  if (out.in_sync) out.engaged.correction = {};
  return out;
}

void require_valid(const Trigger& trigger, const Cam& cam, const std::string& prefix) {
  const bool inside = trigger.position >= cam.start() && trigger.position <= cam.end();
  if (trigger.when == Trigger::When::master_position && !inside)
    throw InputError(
        prefix + "_position", trigger.position,
        "must lie within the cam, " + number(cam.start()) + " to " + number(cam.end()));
  if (!(trigger.window >= 0 && trigger.window <= cam.length() / 2))
    throw InputError(prefix + "_window", trigger.window,
                     "must be from 0 to half of the cam, " + six_digits(cam.length() / 2));
}

Due due(const Trigger& trigger, const Cam& cam, const Placement& placement, const Sample& before,
        const Sample& now) {
  if (trigger.when == Trigger::When::now) return {.at = now};
  const bool at_end = trigger.when == Trigger::When::period_end;
  const double origin = at_end ? cam.end() : trigger.position;
  const double X = placement.at(now.master[0]);
  const double apart = placement.periodic ? std::remainder(X - origin, cam.length()) : X - origin;
  const double window = at_end ? 0 : trigger.window;
  if (std::abs(apart) <= std::max(window, rounded_sum * cam.length())) return {.at = now};

  double level = (origin - placement.master_offset) / placement.master_scaling;
  if (placement.periodic) {
    const Crossings ends =
        ends_between(origin, cam.length(), placement, before.master[0], now.master[0]);
    if (ends.count == 0) return {.at = {}};
    level = ends.level;
  }
  const auto passed = passing(before, now, level);
  if (passed && window > 0) return {.status = CouplingStatus::window_missed, .at = {}};
  return {.at = passed};
}

Engagement exchange(const Coupling& running, const Engaged& engaged, const Coupling& next,
                    const Sample& at) {
  // A master at the joint of two periods has just arrived there: the slave is at the end of the
  // period, not yet at the start of the next. If the master was already at rest there, the last
  // cycle has set the side.
  const bool arrives = at.t > engaged.time && at.master[0] != engaged.master[0];
  const Jet y = point(running, engaged, at.master, at.t, arrives ? Side::left : Side::right);
  return engage(next, state(y), at.master, at.t);
}

}  // namespace jounce
