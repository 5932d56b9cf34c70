// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/synchronize.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "jounce/profiles/detail/tolerances.hpp"

#include "profiles/src/solver/axis_task.hpp"
#include "profiles/src/solver/brake.hpp"
#include "profiles/src/solver/even_rest.hpp"
#include "profiles/src/solver/solver.hpp"
#include "profiles/src/solver/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::AxisTask;
using profiles_detail::rounded_sum;
using profiles_detail::same_duration;

/// The condition for the durations: at least `minimum`, and a multiple of `grid` if that is > 0.
struct Timing {
  double minimum;
  double grid;
};

constexpr double rounding_of_duration = 1e-13;

/// The next multiple of the grid.
double on_grid(double t, double grid) {
  return grid > 0 ? std::ceil(t / grid * (1 - same_duration)) * grid : t;
}

/// The least permitted duration on the grid that is not less than t.
double at_least(const Durations& allowed, double t, double grid) {
  double next = on_grid(allowed.at_least(t), grid);
  while (!allowed.allows(next)) next = on_grid(allowed.at_least(next), grid);
  return next;
}

/// Computes the motion that lasts t. If t is blocked, t becomes the next possible duration.
MoveStatus lasting(const AxisTask& task, double& t, double grid, Profile& out) {
  MoveStatus status = task.lasting(t, out);
  // At the edge of a blocked interval, rounding decides; then a slightly longer duration is tried.
  for (double more = 0; status == MoveStatus::blocked; more = 16 * more + 0x1p-52) {
    t = at_least(task.durations(), t * (1 + more), grid);
    status = task.lasting(t, out);
  }
  return status;
}

Profile left_out(const AxisMove& axis) {
  return {axis.from, 3};
}

/// The tasks of all axes. The first ones are stored because each is used again; the others are made
/// at each use.
class Tasks {
 public:
  Tasks(std::span<const AxisMove> axes, bool keeps) noexcept
      : axes_(axes), kept_(keeps ? std::min(axes.size(), capacity) : 0) {
    for (std::size_t i = 0; i < kept_; ++i) ::new (&all_[i].task) AxisTask(axes[i]);
  }

  const AxisTask& of(std::size_t i) {
    return i < kept_ ? all_[i].task : *::new (&all_[capacity].task) AxisTask(axes_[i]);
  }

 private:
  static constexpr std::size_t capacity = 16;
  union Slot {          // std::optional would be cleared first
    Slot() noexcept {}  // NOLINT(modernize-use-equals-default): a defaulted one would be deleted
    AxisTask task;
  };

  std::span<const AxisMove> axes_;
  std::size_t kept_;
  std::array<Slot, capacity + 1> all_;
};

/// The shortest motion of one enabled axis, or the next one on the grid.
MoveStatus alone(const AxisMove& axis, const AxisTask& task, const Timing& timing, Profile& out) {
  MoveStatus status = task.status();
  if (status == MoveStatus::ok)
    status = task.shortest(out);
  else
    out = left_out(axis);
  if (status != MoveStatus::ok || (timing.minimum <= 0 && timing.grid <= 0)) return status;
  const double shortest = out.duration();
  double t = on_grid(std::max(shortest, timing.minimum), timing.grid);
  if (t > shortest * (1 + same_duration)) {
    t = at_least(task.durations(), t, timing.grid);
    status = lasting(task, t, timing.grid, out);
  }
  return status;
}

Synchronized each(std::span<const AxisMove> axes, std::span<Profile> out, const Timing& timing,
                  Tasks& tasks) {
  Synchronized result;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!axes[i].enabled) {
      out[i] = left_out(axes[i]);
      continue;
    }
    const MoveStatus status = alone(axes[i], tasks.of(i), timing, out[i]);
    if (status != MoveStatus::ok) return {status, i, 0};
    result.duration = std::max(result.duration, out[i].duration());
  }
  return result;
}

Synchronized each(std::span<const AxisMove> axes, std::span<Profile> out, const Timing& timing) {
  Tasks tasks(axes, false);
  return each(axes, out, timing, tasks);
}

/// The index of the next axis, cyclically.
std::size_t after(std::size_t i, std::size_t axes) {
  return i + 1 < axes ? i + 1 : 0;
}

/// The search for a common duration: from `next` on, cyclically, each axis is tested until all of
/// them agree.
struct Agreement {
  Synchronized common;
  std::size_t next = 0;
  /// Number of axes just before `next` whose motion already has this duration.
  std::size_t agreed = 0;
};

/// The least duration in which all axes can move. If an axis can cruise in the duration that
/// another one needs, this is its motion, and its shortest motion is not computed. So the axis that
/// probably takes longest comes first.
Agreement in_least_time(std::span<const AxisMove> axes, std::span<Profile> out,
                        const Timing& timing, Tasks& tasks) {
  Agreement result;
  double& t = result.common.duration;
  double most = -Bounds::none;
  std::size_t usual = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const AxisTask& task = tasks.of(i);
    if (axes[i].enabled && task.is_usual()) {
      const double about = task.about();
      result.next = about > most ? i : result.next;
      most = std::max(most, about);
      ++usual;
      continue;
    }
    out[i] = left_out(axes[i]);
    if (!axes[i].enabled) continue;
    const MoveStatus status = alone(axes[i], task, {0, 0}, out[i]);
    if (status != MoveStatus::ok) return {{status, i, 0}};
    t = std::max(t, out[i].duration());
  }
  for (std::size_t k = 0, i = result.next; k < axes.size(); ++k, i = after(i, axes.size())) {
    const AxisTask& task = tasks.of(i);
    if (!axes[i].enabled || !task.is_usual()) continue;
    const double common = on_grid(std::max(t, timing.minimum), timing.grid);
    ++result.agreed;
    if (common > 0 && task.cruises(common, out[i])) continue;
    (void)task.shortest(out[i]);
    const double shortest = out[i].duration();
    if (shortest != t)
      // Either this axis does not agree, or those before it do not.
      result.agreed = shortest > t ? 1 : 0;
    t = std::max(t, shortest);
  }
  if (usual < axes.size() || t != on_grid(std::max(t, timing.minimum), timing.grid))
    result.agreed = 0;
  return result;
}

bool rests(const AxisMove& axis) {
  return axis.goal != MoveGoal::moving && axis.to.velocity == 0 && axis.to.acceleration == 0;
}

/// For axes that all go from rest to rest with the same limits in both directions: the slowest
/// determines the duration of all. Returns false if an axis has another task.
bool resting_in_time(std::span<const AxisMove> axes, std::span<Profile> out, const Timing& timing,
                     double& t) {
  constexpr std::size_t capacity = 16;
  if (axes.size() > capacity) return false;
  std::array<profiles_detail::EvenRest, capacity> rests;
  std::array<profiles_detail::EvenCourse, capacity> courses;
  double least = timing.minimum;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto& [from, to, bounds, goal, enabled, under_way] = axes[i];
    if (!enabled || goal != MoveGoal::state || under_way ||
        profiles_detail::form(from, to, bounds) != profiles_detail::Form::even_rest)
      return false;
    rests[i] = {from, to, bounds};
    courses[i] = rests[i].shortest();
    least = profiles_detail::greatest(least, courses[i].duration());
  }
  t = on_grid(least, timing.grid);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const bool is_slowest = courses[i].duration() >= t * (1 - rounding_of_duration);
    if (!is_slowest && !rests[i].lasting(t, courses[i])) return false;
    ::new (&out[i])
        Profile(profile_of(courses[i], axes[i].bounds.jerk_max, axes[i].from, axes[i].to));
  }
  return true;
}

/// All axes in the least time that is possible for all. With `if_moving`, an axis whose target is
/// at rest keeps its shortest motion.
Synchronized in_time(std::span<const AxisMove> axes, std::span<Profile> out, const Timing& timing,
                     bool if_moving) {
  if (double t = 0; !if_moving && resting_in_time(axes, out, timing, t))
    return {MoveStatus::ok, 0, t};
  Tasks tasks(axes, true);
  Agreement all = if_moving ? Agreement{each(axes, out, {0, timing.grid}, tasks)}
                            : in_least_time(axes, out, timing, tasks);
  if (all.common.status != MoveStatus::ok) return all.common;
  const bool all_rest =
      if_moving && std::all_of(axes.begin(), axes.end(),
                               [](const AxisMove& axis) { return !axis.enabled || rests(axis); });
  if (all_rest) return all.common;  // each keeps its shortest motion
  double& t = all.common.duration;
  t = on_grid(std::max(t, timing.minimum), timing.grid);
  for (std::size_t i = all.next; all.agreed < axes.size();
       i = after(i, axes.size()), ++all.agreed) {
    if (!axes[i].enabled || (if_moving && rests(axes[i]))) continue;
    // A difference of durations within rounding is ignored: a velocity computed from it would be
    // arbitrary.
    if (std::abs(out[i].duration() - t) <= rounding_of_duration * t) continue;
    const double before = t;
    const MoveStatus status = lasting(tasks.of(i), t, timing.grid, out[i]);
    if (status != MoveStatus::ok) return {status, i, 0};
    if (t != before) all.agreed = 0;
  }
  return all.common;
}

/// A component of an axis that can define the common line: the distance, or, if that is 0 for all
/// axes, a rate.
double component(const AxisMove& m, int which) {
  switch (which) {
    case 0:
      return m.to.position - m.from.position;
    case 1:
      return m.from.velocity;
    case 2:
      return m.to.velocity;
    case 3:
      return m.from.acceleration;
    default:
      return m.to.acceleration;
  }
}

/// The axis that moves farthest, and the component that defines this; `which` is 5 if nothing
/// moves.
struct Leader {
  std::size_t axis = 0;
  int which = 0;
};

Leader leader(std::span<const AxisMove> axes) {
  for (int which = 0; which < 5; ++which) {
    Leader l{0, 5};
    double most = 0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (!axes[i].enabled) continue;
      const double rate = std::abs(component(profiles_detail::posed(axes[i]), which));
      if (rate > most) {
        most = rate;
        l = {i, which};
      }
    }
    if (most > 0) return l;
  }
  return {0, 5};
}

/// Restricts the bounds of the leader by those of an axis whose rates are `ratio` times the
/// leader's.
void intersect(Bounds& lead, const AxisMove& axis, double lead_from, double ratio) {
  const auto both = [ratio](double min, double max, double& lead_min, double& lead_max) {
    const double lo = (ratio > 0 ? min : max) / ratio;
    const double hi = (ratio > 0 ? max : min) / ratio;
    // An axis that hardly moves is no limit.
    if (lo > -1e50) lead_min = std::max(lead_min, lo);
    if (hi < 1e50) lead_max = std::min(lead_max, hi);
  };
  const Bounds& b = axis.bounds;
  both(b.velocity_min, b.velocity_max, lead.velocity_min, lead.velocity_max);
  both(b.acceleration_min, b.acceleration_max, lead.acceleration_min, lead.acceleration_max);
  both(b.jerk_min, b.jerk_max, lead.jerk_min, lead.jerk_max);
  double lo = -Bounds::none;
  double hi = Bounds::none;
  both(b.position_min - axis.from.position, b.position_max - axis.from.position, lo, hi);
  lead.position_min = std::max(lead.position_min, lead_from + lo);
  lead.position_max = std::min(lead.position_max, lead_from + hi);
}

/// True if a component of an axis is `ratio` times that of the leader. The tolerance is the
/// rounding of the positions and of the states of a running motion, whose last digits are those of
/// the positions and of the bounds.
bool on_line(const AxisMove& axis, const AxisMove& lead, int which, double ratio, double scale) {
  constexpr double digits = 0x1p-48;
  const auto far = [](const AxisMove& m) {
    return std::abs(m.from.position) + std::abs(m.to.position);
  };
  const auto bound = [which](const Bounds& b) {
    const double most = which < 3 ? std::max(b.velocity_max, -b.velocity_min)
                                  : std::max(b.acceleration_max, -b.acceleration_min);
    return which > 0 && std::isfinite(most) ? most : 0;
  };
  const double here = component(axis, which);
  const double there = component(lead, which);
  const double of_ratio = (far(axis) + std::abs(ratio) * far(lead)) / std::abs(scale);
  const double slack = rounded_sum * (std::abs(here) + std::abs(ratio * there)) +
                       digits * (of_ratio * std::abs(there) + (which == 0 ? far(axis) : 0) +
                                 bound(axis.bounds) + std::abs(ratio) * bound(lead.bounds));
  return std::abs(here - ratio * there) <= slack;
}

/// Checks that all axes that begin within their bounds keep their velocity limits: the velocity of
/// the line passes the one at which its acceleration has returned to zero.
Synchronized kept_velocities(std::span<const AxisMove> axes, const AxisMove& lead, int which,
                             const Bounds& line) {
  constexpr double forgiven = 1e-12;
  if (profiles_detail::order_of(line) < 3) return {};
  const double peak = profiles_detail::natural_velocity(lead.from, line);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!axes[i].enabled) continue;
    const AxisMove axis = profiles_detail::posed(axes[i]);
    const double v = component(axis, which) / component(lead, which) * peak;
    const bool outside = v > axis.bounds.velocity_max * (1 + forgiven) ||
                         v < axis.bounds.velocity_min * (1 + forgiven);
    // An axis that is outside its bounds returns as the line does.
    if (outside && profiles_detail::is_inside(axis.from, axis.bounds, forgiven))
      return {MoveStatus::not_straight, i, 0};
  }
  return {};
}

/// Checks that all goals are valid and of the same kind.
Synchronized one_kind(std::span<const AxisMove> axes, MoveGoal goal) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!axes[i].enabled) continue;
    const MoveStatus status = AxisTask(axes[i]).status();
    if (status != MoveStatus::ok) return {status, i, 0};
    if (axes[i].goal != goal) return {MoveStatus::not_straight, i, 0};
  }
  return {};
}

Synchronized in_phase(std::span<const AxisMove> axes, std::span<Profile> out,
                      const Timing& timing) {
  const Leader lead = leader(axes);
  if (const Synchronized s = one_kind(axes, axes[lead.axis].goal); s.status != MoveStatus::ok)
    return s;
  if (lead.which == 5) return each(axes, out, timing);
  AxisMove first = profiles_detail::posed(axes[lead.axis]);
  const double scale = component(first, lead.which);
  Bounds bounds = first.bounds;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!axes[i].enabled) continue;
    const AxisMove axis = profiles_detail::posed(axes[i]);
    const double ratio = component(axis, lead.which) / scale;
    for (int k = 0; k < 5; ++k)
      if (!on_line(axis, first, k, ratio, scale)) return {MoveStatus::not_straight, i, 0};
    if (ratio != 0) intersect(bounds, axis, first.from.position, ratio);
  }
  if (const Synchronized s = kept_velocities(axes, first, lead.which, bounds);
      s.status != MoveStatus::ok)
    return s;
  Profile along;
  first = {first.from, first.to, bounds};
  if (const Synchronized s = each({&first, 1}, {&along, 1}, timing); s.status != MoveStatus::ok)
    return {s.status, lead.axis, 0};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    out[i] = left_out(axes[i]);
    if (!axes[i].enabled) continue;
    const AxisMove axis = profiles_detail::posed(axes[i]);
    const double ratio = component(axis, lead.which) / scale;
    const MoveStatus status =
        profiles_detail::answered(axes[i], along.scaled(ratio, axis.from, axis.to), out[i]);
    if (status != MoveStatus::ok) return {status, i, 0};
  }
  return {MoveStatus::ok, 0, along.duration()};
}

}  // namespace

Synchronized synchronize(std::span<const AxisMove> axes, Sync sync, std::span<Profile> out,
                         double minimum_duration, double grid) noexcept {
  if (axes.size() != out.size()) return {MoveStatus::wrong_size, 0, 0};
  if (!std::isfinite(minimum_duration) || !std::isfinite(grid))
    return {MoveStatus::not_finite, 0, 0};
  if (axes.empty()) return {};
  const Timing timing{minimum_duration, grid};
  if (sync == Sync::none) return each(axes, out, timing);
  if (sync == Sync::phase || sync == Sync::phase_or_time) {
    const Synchronized straight = in_phase(axes, out, timing);
    if (sync == Sync::phase || straight.status != MoveStatus::not_straight) return straight;
  }
  return in_time(axes, out, timing, sync == Sync::time_if_moving);
}

}  // namespace jounce
