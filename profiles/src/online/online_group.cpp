// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/online/online_group.hpp"

#include <cmath>

#include "profiles/src/solver/axis_task.hpp"

namespace jounce::profiles_detail {

OnlineStep OnlineGroup::step(double dt) noexcept {
  OnlineStep result{.arrived = true, .planned = regroup};
  if (!(dt >= 0 && std::isfinite(dt))) {
    dt = 0;
    result.status = MoveStatus::not_finite;
  }
  for (OnlineAxis& axis : axes) result.planned = axis.look() || result.planned;
  if (result.planned) plan();
  bool halts = false;
  for (OnlineAxis& axis : axes) {
    if (axis.runs_out(dt)) axis.halt(MoveStatus::position_limit);
    halts = halts || axis.halts();
  }
  if (halts) stop();
  result.planned = result.planned || halts;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    axes[i].advance(dt);
    result.arrived = result.arrived && axes[i].arrived();
    if (result.status == MoveStatus::ok && axes[i].status() != MoveStatus::ok) {
      result.status = axes[i].status();
      result.axis = i;
    }
  }
  return result;
}

bool OnlineGroup::in_phase() const noexcept {
  return sync == Sync::phase || sync == Sync::phase_or_time;
}

/// Each pass plans all axes, or excludes an axis that cannot reach its goal.
void OnlineGroup::plan() noexcept {
  bool held = false;
  for (OnlineAxis& axis : axes) {
    if (sync == Sync::phase || regroup) axis.reconsider();
    if (axis.stale() && axis.must_stop()) axis.halt(MoveStatus::ok);
    held = held || axis.is_held();
  }
  if (held && sync == Sync::phase) {  // without this axis the line cannot be kept
    for (OnlineAxis& axis : axes)
      if (axis.takes_part()) axis.halt(MoveStatus::not_straight);
  }
  while (gather(false)) {
    const Synchronized result = solve();
    if (result.status == MoveStatus::ok) return go();
    refuse(result);
  }
}

/// Collects the tasks of the axes; returns false if there are none.
bool OnlineGroup::gather(bool widened) noexcept {
  bool any = false;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const OnlineAxis& axis = axes[i];
    const bool alone = sync == Sync::none && !regroup;
    if (!axis.takes_part() || (alone && !axis.stale())) {
      moves[i].enabled = false;
      continue;
    }
    any = true;
    moves[i] = axis.move(widened);
    if (axis.stale() || (in_phase() && !bent)) continue;
    rests[i] = axis.rest_of_plan();
    moves[i].under_way = &rests[i];
  }
  return any;
}

/// On a line, the limits of one axis act on all. So a lowered limit may lead another axis past its
/// target or its velocity limit.
Synchronized OnlineGroup::solve() noexcept {
  Synchronized result = synchronize(moves, sync, next, 0, grid);
  const bool bends = result.status == MoveStatus::not_straight;
  if (in_phase() && (bends || result.status == MoveStatus::ok) && can_widen() &&
      (bends || detour(Judged::strictly))) {
    gather(true);
    result = synchronize(moves, sync, next, 0, grid);
    if (result.status != MoveStatus::ok || detour(Judged::mildly)) {
      gather(false);
      result = synchronize(moves, sync, next, 0, grid);
    }
  }
  if (sync == Sync::phase && is_on_its_way() &&
      (result.status == MoveStatus::not_straight ||
       (result.status == MoveStatus::ok && detour(Judged::mildly))))
    result = bend(result);
  if ((sync != Sync::phase || bent) && sync != Sync::none && result.status == MoveStatus::ok)
    wait_rather_than_turn_round();
  return result;
}

/// True if all enabled axes already move to their goals, so that only bounds have changed.
bool OnlineGroup::is_on_its_way() const noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (moves[i].enabled && !axes[i].is_on_its_way()) return false;
  return true;
}

/// Lets the axes leave the line, if they then do not pass their goals or reverse.
Synchronized OnlineGroup::bend(const Synchronized& straight) noexcept {
  bent = true;
  gather(false);
  const Synchronized result = synchronize(moves, Sync::time, next, 0, grid);
  if (straight.status != MoveStatus::ok || result.status != MoveStatus::ok) return result;
  wait_rather_than_turn_round();
  if (!detour(Judged::mildly)) return result;
  bent = false;
  gather(false);
  return synchronize(moves, sync, next, 0, grid);
}

bool OnlineGroup::can_widen() const noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (moves[i].enabled && axes[i].can_widen()) return true;
  return false;
}

bool OnlineGroup::detour(Judged judged) const noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (moves[i].enabled && detours(moves[i], next[i], judged)) return true;
  return false;
}

/// An axis that already brakes cannot take longer without reversing. If its target is at rest, it
/// arrives earlier and waits there.
void OnlineGroup::wait_rather_than_turn_round() noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const AxisMove& m = moves[i];
    const bool rests_there =
        m.goal == MoveGoal::moving || (m.to.velocity == 0 && m.to.acceleration == 0);
    if (!m.enabled || !rests_there || !detours(m, next[i], Judged::mildly)) continue;
    Profile shortest;
    if (AxisTask(m).shortest(shortest) == MoveStatus::ok && !detours(m, shortest, Judged::mildly))
      next[i] = shortest;
  }
}

void OnlineGroup::refuse(const Synchronized& why) noexcept {
  if (why.status != MoveStatus::not_straight) return axes[why.axis].refuse(why.status);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (moves[i].enabled) axes[i].refuse(why.status);
}

void OnlineGroup::go() noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const AxisMove& m = moves[i];
    if (!m.enabled) continue;
    const bool kept = m.under_way && next[i].duration() == m.under_way->duration() &&
                      next[i].end() == m.under_way->end();
    if (kept) continue;
    if (axes[i].permits(next[i]))
      axes[i].go(m, next[i]);
    else
      axes[i].refuse(MoveStatus::target_outside);
    if (bent) axes[i].bend();
  }
}

void OnlineGroup::gather_halting(bool widened) noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    moves[i].enabled = axes[i].halts();
    if (axes[i].halts()) moves[i] = axes[i].stopping(widened);
  }
}

/// Stops; on the line, if the axes move on one.
void OnlineGroup::stop() noexcept {
  bool on_line = false;
  for (const bool widened : {false, true}) {
    if (on_line || !in_phase()) break;
    gather_halting(widened);
    on_line = synchronize(moves, Sync::phase, next).status == MoveStatus::ok;
  }
  if (!on_line) gather_halting(false);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!moves[i].enabled) continue;
    const AxisTask task(moves[i]);
    if (!on_line && (task.status() != MoveStatus::ok || task.shortest(next[i]) != MoveStatus::ok))
      next[i] = Profile(moves[i].from, 3);
    axes[i].stop(moves[i], next[i]);
  }
}

}  // namespace jounce::profiles_detail
