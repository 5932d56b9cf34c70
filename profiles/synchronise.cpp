#include "jounce/profiles/synchronise.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/detail/solver.hpp"

namespace jounce {
namespace {

using detail::Solver;

Solver solver(const AxisMove& axis) {
  return {axis.from, axis.to, axis.bounds};
}

Synchronised each(std::span<const AxisMove> axes, std::span<Profile> out, double minimum = 0) {
  Synchronised result;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto& [from, to, bounds] = axes[i];
    MoveStatus status = detail::status_of(from, to, bounds);
    if (status == MoveStatus::ok) status = solver(axes[i]).shortest(out[i]);
    if (status == MoveStatus::ok && minimum > out[i].duration())
      status = solver(axes[i]).lasting(solver(axes[i]).durations().at_least(minimum), out[i]);
    if (status != MoveStatus::ok) return {status, i, 0};
    result.duration = std::max(result.duration, out[i].duration());
  }
  return result;
}

/// All in the least time that each can do: whenever one cannot, in the next time that it can.
Synchronised in_time(std::span<const AxisMove> axes, std::span<Profile> out, double minimum) {
  Synchronised result = each(axes, out);
  if (result.status != MoveStatus::ok) return result;
  double& t = result.duration;
  t = std::max(t, minimum);
  for (std::size_t i = 0, agreed = 0; agreed < axes.size(); i = (i + 1) % axes.size(), ++agreed) {
    if (out[i].duration() == t) continue;
    const Solver axis = solver(axes[i]);
    MoveStatus status = axis.lasting(t, out[i]);
    // At the very edge of a blocked interval rounding decides: then a little later.
    for (double more = 0; status == MoveStatus::blocked; more = 16 * more + 0x1p-52) {
      t = axis.durations().at_least(t * (1 + more));
      agreed = 0;
      status = axis.lasting(t, out[i]);
    }
    if (status != MoveStatus::ok) return {status, i, 0};
  }
  return result;
}

/// What of an axis may define the common line: the distance, or where nothing moves, a rate.
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

/// The axis that goes farthest, and in which component; `which` is 5 if nothing moves at all.
struct Leader {
  std::size_t axis = 0;
  int which = 0;
};

Leader leader(std::span<const AxisMove> axes) {
  for (Leader l; l.which < 5; ++l.which) {
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (std::abs(component(axes[i], l.which)) > std::abs(component(axes[l.axis], l.which)))
        l.axis = i;
    if (component(axes[l.axis], l.which) != 0) return l;
  }
  return {0, 5};
}

/// The bounds of an axis whose rates are `ratio` times the leader's, as bounds of the leader.
void intersect(Bounds& lead, const AxisMove& axis, double lead_from, double ratio) {
  const auto both = [ratio](double min, double max, double& lead_min, double& lead_max) {
    const double lo = (ratio > 0 ? min : max) / ratio;
    const double hi = (ratio > 0 ? max : min) / ratio;
    // An axis that hardly moves limits nothing.
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

/// Whether a component of an axis is `ratio` times the leader's, as well as positions and the states of
/// a running motion can tell: their last digits are those of the positions and of the bounds.
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
  const double slack = 1e-12 * (std::abs(here) + std::abs(ratio * there)) +
                       digits * (of_ratio * std::abs(there) + (which == 0 ? far(axis) : 0) +
                                 bound(axis.bounds) + std::abs(ratio) * bound(lead.bounds));
  return std::abs(here - ratio * there) <= slack;
}

Synchronised in_phase(std::span<const AxisMove> axes, std::span<Profile> out, double minimum) {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const MoveStatus s = detail::status_of(axes[i].from, axes[i].to, axes[i].bounds);
        s != MoveStatus::ok)
      return {s, i, 0};
  const Leader lead = leader(axes);
  if (lead.which == 5) return each(axes, out, minimum);
  const AxisMove& first = axes[lead.axis];
  const double scale = component(first, lead.which);
  Bounds bounds = first.bounds;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double ratio = component(axes[i], lead.which) / scale;
    for (int k = 0; k < 5; ++k)
      if (!on_line(axes[i], first, k, ratio, scale)) return {MoveStatus::not_straight, i, 0};
    if (ratio != 0) intersect(bounds, axes[i], first.from.position, ratio);
  }
  Move move = move_to(first.from, first.to, bounds);
  if (move && minimum > move.profile.duration())
    move = move_to(first.from, first.to, bounds,
                   durations(first.from, first.to, bounds).at_least(minimum));
  if (!move) return {move.status, lead.axis, 0};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double ratio = component(axes[i], lead.which) / scale;
    out[i] = move.profile.scaled(ratio, axes[i].from, axes[i].to);
  }
  return {MoveStatus::ok, 0, move.profile.duration()};
}

}  // namespace

Synchronised synchronise(std::span<const AxisMove> axes, Sync sync, std::span<Profile> out,
                         double minimum_duration) noexcept {
  assert(axes.size() == out.size());
  if (!std::isfinite(minimum_duration)) return {MoveStatus::not_finite, 0, 0};
  if (axes.empty()) return {};
  switch (sync) {
    case Sync::none:
      return each(axes, out, minimum_duration);
    case Sync::time:
      return in_time(axes, out, minimum_duration);
    case Sync::phase:
      break;
  }
  return in_phase(axes, out, minimum_duration);
}

}  // namespace jounce
