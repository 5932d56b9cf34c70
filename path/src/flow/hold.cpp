// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"

#include "path/src/flow/partial_law.hpp"
#include "path/src/tolerances.hpp"

// A stretch of the law of stations carries its box. From v over L, the lowest velocity that a ramp
// reaches is 0 if D(v, 0) <= L. Otherwise D(v, v - x) grows with x up to max(2 v / 3, v - d^2 / 2
// j), where d is the deceleration and j the jerk, and then falls to D(v, 0) > L: there is one root
// before that. If the plan goes from V to e over L and v <= V, then D(v, e) <= D(V, e) <= L. So the
// held law is at no station faster than the plan, and it rests at the latest where the plan rests.

namespace jounce {

Plan halted(const Plan& plan, double t) {
  if (!(t >= 0 && t <= plan.duration()))
    throw InputError("t", t, "must be from 0 to " + number(plan.duration()));
  const LawStretches& stretches = plan.law().stretches();
  const auto at = plan.law().find(t);
  PartialLaw held;
  for (auto s = stretches.begin(); s != at; ++s) held.add(*s);
  const LawInterval& here = *at;
  const double into = std::min(t - here.time, here.duration);
  auto last = at;  // the stretch at whose end the plan rests
  while (last.index() + 1 < stretches.size() && last->v1 > 0) ++last;
  // A stop may last longer than the plan's own way to its next rest, which may use higher limits on the next piece.
  const auto made = [&] {
    if (last->time + last->duration < held.time()) {
      held.law.assign(stretches.begin(), last);
      held.law.push_back(*last);
    }
    if (held.law.empty())
      held.until(here, std::min(here.duration, path_detail::shortest_rest * plan.duration()));
    return Plan(plan.path(), TimingLaw(held.law),
                {plan.junctions().begin(), plan.junctions().end()}, plan.stop_duration(),
                plan.given());
  };
  if (here.pieces == 0) {  // in a dwell
    if (into > 0) {
      LawInterval rest = here;
      rest.duration = into;
      held.add(rest);
    }
    return made();
  }
  double v = here.v1;
  const Motion now = motion_in(here, into);
  if (!here.is_phase() && !is_corner(here)) {
    const MoveResult stopping =
        stop(state_of(now), within(Bounds::none, here.deceleration, here.jerk));
    if (stopping && stopping.profile.end().position <= here.length) {
      held.until(here, into);
      Motion m = now;
      for (std::size_t k = 0; k < stopping.profile.phases(); ++k) {
        const auto [h, rate] = stopping.profile.phase(k);
        const bool limited = std::isfinite(here.jerk);
        m.jerk = limited ? rate : 0;
        if (!limited) m.acceleration = rate;
        held.phase(here, m.position, h, m);
        m.position += h * (m.velocity + h * (m.acceleration / 2 + h * m.jerk / 6));
        m.velocity += h * (m.acceleration + h * m.jerk / 2);
        m.acceleration += h * m.jerk;
      }
      held.law.back().v1 = 0;  // exactly, without rounding
      return made();
    }
  }
  held.add(here);
  for (auto next = std::next(at); next != stretches.end() && v > 0;) {
    LawInterval s = *next++;
    if (s.is_phase()) {
      v = s.v1;
    } else {
      s.v0 = s.peak = v;
      if (!is_corner(s)) {
        // At most the plan's own end velocity, except for rounding: a ramp to that velocity might not fit.
        const double end = s.v1 == 0 ? 0 : lowest_end(unit_of(s).box, s.length, v);
        if (end == 0) s.length = std::min(s.length, ramp_distance(v, 0, s.deceleration, s.jerk));
        s.v1 = v = end;
      } else {
        s.v1 = v;
      }
      std::array<LawPhase, 7> phases_of;
      const std::size_t count = phases(s, phases_of);
      s.duration = 0;
      for (std::size_t k = 0; k < count; ++k) s.duration += phases_of[k].duration;
    }
    held.add(s);
    if (next != stretches.end() && next->pieces == 0) break;
  }
  return made();
}

namespace {

using profiles_detail::rounded_value;
/// The rest of a plan that rests at `from`, where it has already dwelled for `rested` s.
Plan remaining(const Plan& plan, double from, double rested) {
  const double end = plan.path().length();
  std::vector<LawInterval> law;
  std::vector<Unit> units;
  double time = 0;
  double start = from;
  const auto flush = [&] {
    if (units.empty()) return;
    open_end_corners(units, plan);
    for (LawInterval s : stations(units)) {
      s.time += time;
      s.start += start;
      law.push_back(s);
    }
    time = law.back().time + law.back().duration;
    start = law.back().start + law.back().length;
    units.clear();
  };
  for (const LawInterval& s : plan.law().stretches()) {
    const double stretch_end = s.start + s.length;
    if (stretch_end < from - rounded_value * end) continue;
    if (s.pieces > 0 && stretch_end <= from + rounded_value * end) continue;
    if (s.pieces == 0 || s.is_phase()) {  // a dwell, or a run by a window, which begins at rest
      flush();
      LawInterval same = s;
      same.time = time;
      if (s.pieces == 0 && s.start == from) same.duration -= rested;
      if (!(same.duration > 0)) continue;
      time += same.duration;
      start = stretch_end;
      law.push_back(same);
      continue;
    }
    Unit unit = unit_of(s);
    unit.length = stretch_end - std::max(s.start, from);
    if (units.empty()) unit.entry = PathSettings::none;
    if (s.start < from)
      while (unit.pieces > 1 && plan.path().pieces()[unit.piece + 1].start <= from) {
        ++unit.piece;
        --unit.pieces;
      }
    if (!units.empty() && s.v0 == 0) flush();
    units.push_back(unit);
  }
  flush();
  return {plan.path(),
          TimingLaw(law),
          {plan.junctions().begin(), plan.junctions().end()},
          plan.stop_duration(),
          plan.given()};
}

}  // namespace

Plan resumed(const Plan& plan, const Plan& held) {
  const LawInterval last = held.law().stretches().back();
  const double from = last.start + last.length;
  if (!(from < plan.path().length() * (1 - rounded_value)))
    throw InputError("held", from, "is at the end of the path; nothing remains");
  return remaining(plan, from, last.pieces == 0 ? last.duration : 0);
}

Plan resumed(const Plan& plan, double from) {
  const double end = plan.path().length();
  if (!(from >= 0 && from < end * (1 - rounded_value)))
    throw InputError("from", from, "must be from 0 to less than " + number(end));
  return remaining(by_stations(plan, 1), from, 0);
}

}  // namespace jounce
