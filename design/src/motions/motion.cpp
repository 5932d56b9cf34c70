// SPDX-License-Identifier: Apache-2.0
#include "design/src/motions/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "jounce/optimize/spline_times.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/moves/explain.hpp"
#include "jounce/profiles/sequences/splice.hpp"
#include "jounce/profiles/sequences/via.hpp"
#include "jounce/spec/detail/in_document.hpp"

namespace jounce::design_detail {
namespace {

/// The error for a target whose rate exceeds its bounds, under the key of this rate: "to_velocity". None for a rate
/// within them.
std::optional<InputError> beyond(const std::string& prefix, const char* rate, double value,
                                 double least, double most) {
  const std::string key = prefix + "to_" + rate;
  if (value > most)
    return InputError(key, value, "must be at most " + number(most) + ", the greatest " + rate);
  if (value < least)
    return InputError(key, value, "must be at least " + number(least) + ", the least " + rate);
  return std::nullopt;
}

/// The error of a move that does not exist. `prefix`: of the rates of its target; `key`: of the move.
InputError impossible(const std::string& prefix, const std::string& key, MoveStatus status,
                      const MotionState& from, const MotionState& to, const Bounds& bounds) {
  if (status == MoveStatus::target_outside) {
    if (const auto error =
            beyond(prefix, "velocity", to.velocity, bounds.velocity_min, bounds.velocity_max))
      return *error;
    if (const auto error = beyond(prefix, "acceleration", to.acceleration, bounds.acceleration_min,
                                  bounds.acceleration_max))
      return *error;
  }
  if (status == MoveStatus::position_limit && to.position < bounds.position_min)
    return {prefix + "to", to.position,
            "must be at least position_min = " + number(bounds.position_min)};
  if (status == MoveStatus::position_limit && to.position > bounds.position_max)
    return {prefix + "to", to.position,
            "must be at most position_max = " + number(bounds.position_max)};
  return {key, "", explain(status, from, to, bounds)};
}

/// Throws InputError for a start outside the position limits.
void require_start_inside(double from, const Bounds& bounds) {
  if (from < bounds.position_min)
    throw InputError("from", from,
                     "must be at least position_min = " + number(bounds.position_min) +
                         ": the axis starts outside its position limits");
  if (from > bounds.position_max)
    throw InputError("from", from,
                     "must be at most position_max = " + number(bounds.position_max) +
                         ": the axis starts outside its position limits");
}

Trajectory curve_of(const MoveResult& move, const char* key) {
  if (!move) throw InputError(key, "", explain(move.status));
  if (!(move.profile.duration() > 0))
    throw InputError(key, "", "is the start position: there is no move");
  // Uses the requested states instead of those of the curve: without a limit of acceleration the
  // velocity steps, and the axis is at rest before.
  const bool moves = move.profile.start().velocity != 0 || move.profile.end().velocity != 0;
  const Trajectory curve = move.profile.curve();
  return moves ? with(curve, Extrapolation::refuse) : curve;
}

// ---- a move of each profile ------------------------------------------------------------------

Trajectory made(const TrapezoidSpec& s) {
  return trapezoid(s).curve();
}
Trajectory made(const SCurveSpec& s) {
  return s_curve(s).curve();
}

/// The error for an impossible duration, with the reason and the next possible duration.
InputError refused(const PointToPointSpec& s, const MotionState& to, MoveStatus status) {
  const Durations all = durations(s.from, to, s.bounds);
  const double next = all.at_least(*s.duration);
  if (status == MoveStatus::too_short)
    return {"duration", *s.duration,
            "must be at least " + six_digits_up(next) +
                ": the move takes longer than the given duration"};
  return {"duration", *s.duration,
          std::string(explain(status)) + "; the next longer possible duration is " +
              six_digits_up(next)};
}

MotionState target_of(const PointToPointSpec& s) {
  MotionState to = s.to;
  if (!s.period) return to;
  const ModuloTarget target = modulo_target(s.from, to.position, s.direction, *s.period, s.bounds);
  if (target.status != MoveStatus::ok) throw InputError("direction", "", explain(target.status));
  to.position = target.position;
  return to;
}

Trajectory made(const FourthOrderSpec& s) {
  return fourth_order(s);
}

Trajectory made(const PointToPointSpec& s) {
  const MotionState to = target_of(s);
  const MoveResult move =
      s.duration ? move_to(s.from, to, s.bounds, *s.duration) : move_to(s.from, to, s.bounds);
  if (move.status == MoveStatus::too_short || move.status == MoveStatus::blocked)
    throw refused(s, to, move.status);
  if (move.status == MoveStatus::position_limit) require_start_inside(s.from.position, s.bounds);
  if (!move) throw impossible("", "to", move.status, s.from, to, s.bounds);
  return curve_of(move, "to");
}

Trajectory made(const VelocitySpec& s) {
  const MoveResult move = move_velocity(s.from, s.velocity, s.bounds, s.acceleration);
  if (!move)
    throw impossible("", "to_velocity", move.status, s.from, {0, s.velocity, s.acceleration},
                     s.bounds);
  return curve_of(move, "to_velocity");
}

Trajectory made(const HimcMoveSpec& s) {
  return himc::move_abs(s.from, s.to, s.axis).curve();
}
Trajectory made(const HimcVelocitySpec& s) {
  return moving_at_ends(himc::move_vel(s.from, s.direction, s.axis).curve());
}

Trajectory made(const googol::Trap& s) {
  return googol::trap(s).curve();
}
Trajectory made(const googol::MoveAbsolute& s) {
  return googol::move_absolute(s).curve();
}
Trajectory made(const googol::MoveAbsoluteEx& s) {
  return googol::move_absolute_ex(s).curve();
}
Trajectory made(const GoogolVelocitySpec& s) {
  return moving_at_ends(googol::move_velocity(s.from, s.move).curve());
}
Trajectory made(const GoogolJogSpec& s) {
  return moving_at_ends(googol::jog(s.from, s.velocities, s.parameters));
}

Trajectory made(const AgitoSpec& s) {
  return s.strokes ? agito::repetitive(s.from, s.target, s.settings, *s.strokes, s.rpt_wait)
                   : agito::begin(s.from, s.target, s.settings).curve();
}
Trajectory made(const AgitoSineSpec& s) {
  const double stroke = 2 * s.amplitude;
  if (stroke != std::round(stroke) || std::abs(stroke) > std::numeric_limits<std::int32_t>::max())
    throw InputError("amplitude", s.amplitude, "must be half of RelTrgt");
  return agito::repetitive(s.from, {.rel_trgt = static_cast<std::int32_t>(stroke)},
                           agito::quasi_sine(s.amplitude, s.frequency), s.strokes, s.rpt_wait);
}
Trajectory made(const AgitoJogSpec& s) {
  return moving_at_ends(agito::jog(s.from, s.settings).curve());
}

Trajectory made(const Pmc600Spec& s) {
  return pmc600::move_absolute(s.from, s.to, s.dynamics, s.mode);
}
Trajectory made(const pmc600::LsMove& s) {
  return pmc600::ls_move(s).curve();
}
Trajectory made(const Pmc600LsVelocitySpec& s) {
  return pmc600::ls_move_velocity(s.from, s.velocity, s.acceleration, s.start_velocity).curve();
}
Trajectory made(const pmc600::PositionToVelocity& s) {
  return pmc600::position_to_velocity(s);
}
Trajectory made(const Pmc600InchSpec& s) {
  return pmc600::inch(s.from, s.distance, s.dynamics, s.released);
}
Trajectory made(const Pmc600JogSpec& s) {
  return moving_at_ends(pmc600::jog(s.from, s.inputs, s.dynamics, s.max_velocity));
}

// ---- queue -----------------------------------------------------------------------------------

const char* type_of(const MotionCommand& command) {
  constexpr std::array names{"absolute", "relative", "velocity", "halt", "dwell"};
  return names[command.index()];
}

/// The name of each segment is the command that is active in its middle.
std::vector<std::string> labels_of(const QueueSpec& queue, const QueuedMotion& motion) {
  std::vector<std::string> labels;
  const auto breaks = motion.trajectory.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double middle = (breaks[i] + breaks[i + 1]) / 2;
    const auto running =
        std::find_if(motion.commands.begin(), motion.commands.end(),
                     [&](const CommandRecord& c) { return c.begin < middle && middle <= c.end; });
    if (running == motion.commands.end()) {
      labels.emplace_back("none");
      continue;
    }
    const auto k = static_cast<std::size_t>(running - motion.commands.begin());
    labels.push_back(std::to_string(k + 1) + " " + type_of(queue.commands[k].command));
  }
  return labels;
}

// ---- several axes ----------------------------------------------------------------------------

/// Extends each axis to the end of the longest one. An axis that ends earlier stands still, or
/// continues at its velocity.
void bring_to_one_end(std::vector<Trajectory>& motions) {
  double end = 0;
  for (const Trajectory& motion : motions) end = std::max(end, motion.end());
  for (Trajectory& motion : motions)
    if (motion.end() < end) motion = until(motion, end);
}

std::string key_of(std::size_t axis) {
  return "axis[" + std::to_string(axis + 1) + "]";
}

/// The limit that applies to both directions; none if one direction has none. The times of a spline
/// are computed for magnitudes.
std::optional<double> magnitude_of(double least, double greatest) {
  const double limit = std::min(-least, greatest);
  return std::isfinite(limit) ? std::optional(limit) : std::nullopt;
}

std::vector<Trajectory> in_shortest_times(const AxesSpec& axes) {
  SplineTimesSpec spec{.points = axes.points};
  for (const AxisMove& axis : axes.axes)
    spec.limits.push_back(
        {.velocity = magnitude_of(axis.bounds.velocity_min, axis.bounds.velocity_max),
         .acceleration = magnitude_of(axis.bounds.acceleration_min, axis.bounds.acceleration_max),
         .jerk = magnitude_of(axis.bounds.jerk_min, axis.bounds.jerk_max)});
  return spline_times(spec).best.joints;
}

std::vector<Trajectory> through_points(const AxesSpec& axes) {
  ViaSpec spec = axes.via;
  spec.points = axes.points;
  for (const AxisMove& axis : axes.axes) spec.axes.push_back(axis.bounds);
  try {
    return axes.shortest_times ? in_shortest_times(axes) : via(spec).axes;
  } catch (const InputError& error) {  // axes[1] and points[2] are [[axis]] and [[point]]
    std::string key = error.key();
    if (key.starts_with("axes")) key.replace(0, 4, "axis");
    if (key.starts_with("points")) key.replace(0, 6, "point");
    if (key.starts_with("limits")) key.replace(0, 6, "axis");
    if (key.starts_with("start") || key.starts_with("end")) key = "point";
    throw spec_detail::renamed(error, key);
  }
}

/// The limits of the rates for an axis that moves `ratio` times as far; without limits of the
/// position.
Bounds scaled(const Bounds& b, double ratio) {
  const auto both = [&](double min, double max) {
    return ratio < 0 ? std::pair{ratio * max, ratio * min} : std::pair{ratio * min, ratio * max};
  };
  Bounds all;
  std::tie(all.velocity_min, all.velocity_max) = both(b.velocity_min, b.velocity_max);
  std::tie(all.acceleration_min, all.acceleration_max) =
      both(b.acceleration_min, b.acceleration_max);
  std::tie(all.jerk_min, all.jerk_max) = both(b.jerk_min, b.jerk_max);
  return all;
}

/// If sync is "phase", an axis without limits gets those of the first axis that has some, times
/// the ratio of the distances (line follow, PMC600 manual 6.3).
std::vector<AxisMove> with_followers(const AxesSpec& axes) {
  std::vector<AxisMove> all = axes.axes;
  const auto limited = [](const AxisMove& axis) { return !(axis.bounds == Bounds{}); };
  const auto leader = std::find_if(all.begin(), all.end(), limited);
  if (axes.sync != Sync::phase || leader == all.end()) return all;
  const double way = leader->to.position - leader->from.position;
  for (AxisMove& axis : all) {
    const double ratio = (axis.to.position - axis.from.position) / way;
    if (!limited(axis) && way != 0) axis.bounds = scaled(leader->bounds, ratio == 0 ? 1 : ratio);
  }
  return all;
}

}  // namespace

Trajectory moving_at_ends(const Trajectory& motion) {
  const bool moves =
      motion.jet(motion.start())[1] != 0 || motion.jet(motion.end(), Side::left)[1] != 0;
  return moves ? with(motion, Extrapolation::refuse) : motion;
}

Trajectory motion_of(const MoveSpec& move) {
  try {
    return std::visit([](const auto& spec) { return made(spec); }, move);
  } catch (const InputError& error) {  // the generator uses its own names
    throw spec_detail::renamed(error, "move." + error.key());
  }
}

QueueMotion motion_of(const QueueSpec& spec) {
  try {
    QueuedMotion motion = queue(spec);
    std::vector<std::string> labels = labels_of(spec, motion);
    return {std::move(motion.trajectory), std::move(labels)};
  } catch (const InputError& error) {  // commands[1] is the first [[command]]
    std::string key = error.key();
    if (key.starts_with("commands")) key.replace(0, 8, "command");
    throw spec_detail::renamed(error, key);
  }
}

std::vector<Trajectory> motions_of(const AxesSpec& axes) {
  if (!axes.points.empty()) return through_points(axes);
  std::vector<Profile> profiles(axes.axes.size());
  const std::vector<AxisMove> moves = with_followers(axes);
  const Synchronized all = synchronize(moves, axes.sync, profiles, axes.duration);
  if (all.status != MoveStatus::ok) {
    const AxisMove& move = moves[all.axis];
    throw impossible(key_of(all.axis) + ".", key_of(all.axis), all.status, move.from, move.to,
                     move.bounds);
  }
  if (!(all.duration > 0))
    throw InputError("axis", "", "does not move: all axes are at their targets");
  std::vector<Trajectory> motions;
  for (std::size_t i = 0; i < profiles.size(); ++i)
    motions.push_back(
        profiles[i].duration() > 0
            ? profiles[i].curve()
            : Trajectory({line(all.duration, axes.axes[i].to.position, axes.axes[i].to.position)},
                         0, Extrapolation::hold));
  bring_to_one_end(motions);
  for (Trajectory& motion : motions) motion = moving_at_ends(motion);
  return motions;
}

}  // namespace jounce::design_detail
