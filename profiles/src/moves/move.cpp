// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/move.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "profiles/src/solver/both.hpp"
#include "profiles/src/solver/brake.hpp"
#include "profiles/src/solver/even_rest.hpp"
#include "profiles/src/solver/rest_to_rest.hpp"
#include "profiles/src/solver/second_order.hpp"
#include "profiles/src/solver/solver.hpp"

namespace jounce {
namespace {

constexpr double forgiven = 1e-12;  // share of a limit that rounding may have added
// Products of a few magnitudes in this range neither overflow nor underflow.
constexpr double most = 1e50;
constexpr double least = 1e-50;

bool is_state(const MotionState& s) {
  return std::abs(s.position) + std::abs(s.velocity) + std::abs(s.acceleration) < most;
}

bool is_magnitude(double x) {
  return x >= least && (x <= most || x == Bounds::none);
}

bool is_pair(double min, double max) {
  return is_magnitude(-min) && is_magnitude(max);
}

bool is_either(double min, double max) {
  return std::isfinite(min) == std::isfinite(max);
}

bool are_bounds(const Bounds& b) {
  const bool limited = is_pair(b.velocity_min, b.velocity_max) &&
                       is_pair(b.acceleration_min, b.acceleration_max) &&
                       is_pair(b.jerk_min, b.jerk_max) && is_either(b.jerk_min, b.jerk_max) &&
                       b.position_min < b.position_max;
  const int order = profiles_detail::order_of(b);
  if (!limited || order == 3) return limited;
  return is_either(b.acceleration_min, b.acceleration_max) &&
         (order == 2 || (std::isfinite(b.velocity_min) && std::isfinite(b.velocity_max)));
}

MoveStatus target_status(const MotionState& to, const Bounds& b, int order) {
  const auto outside = [](double x, double min, double max) {
    return x < min * (1 + forgiven) || x > max * (1 + forgiven);
  };
  if (outside(to.velocity, b.velocity_min, b.velocity_max) ||
      outside(to.acceleration, b.acceleration_min, b.acceleration_max))
    return MoveStatus::target_outside;
  if (order < 3) return MoveStatus::ok;
  // Backwards in time the acceleration has the opposite sign.
  const MotionState before{to.position, to.velocity, -to.acceleration};
  const Bounds backwards{b.velocity_min,      b.velocity_max, -b.acceleration_max,
                         -b.acceleration_min, b.jerk_min,     b.jerk_max};
  return profiles_detail::is_inside(before, backwards, forgiven) ? MoveStatus::ok
                                                                 : MoveStatus::target_unreachable;
}

// The same checks without branches, for both directions at once in the two lanes of a vector.
using profiles_detail::Both;
using profiles_detail::every;
using profiles_detail::Vector2;

/// A signed number as seen downwards and upwards.
JOUNCE_INLINE Vector2 directed(double x) {
  return Vector2{-x, x};
}

struct Magnitudes {
  Vector2 velocity, acceleration, jerk, position;

  JOUNCE_INLINE explicit Magnitudes(const Bounds& b)
      : velocity{-b.velocity_min, b.velocity_max},
        acceleration{-b.acceleration_min, b.acceleration_max},
        jerk{-b.jerk_min, b.jerk_max},
        position{-b.position_min, b.position_max} {}

  JOUNCE_INLINE static Both none(Vector2 m) { return Both::equal(m, every<Vector2>(Bounds::none)); }
  JOUNCE_INLINE static Both finite(Vector2 m) { return Both::at_most(m, every<Vector2>(most)); }
  /// True if the bounds are valid: no position limits, and second order (the acceleration steps) or
  /// third.
  JOUNCE_INLINE Both limit(bool steps) const {
    const Vector2 lowest =
        profiles_detail::least(velocity, profiles_detail::least(acceleration, jerk));
    const Both common = Both::at_most(every<Vector2>(least), lowest) &
                        (finite(velocity) | none(velocity)) & none(position);
    if (steps) return common & finite(acceleration) & none(jerk);
    return common & (finite(acceleration) | none(acceleration)) & finite(jerk);
  }
  /// True if velocity and acceleration are within their limits, which are increased by the factor
  /// `more`.
  JOUNCE_INLINE Both hold(double v, double a, double more) const {
    return Both::at_most(directed(v), velocity * more) &
           Both::at_most(directed(a), acceleration * more);
  }
  /// True if the velocity stays within its limits while the acceleration returns to zero
  /// (is_inside).
  JOUNCE_INLINE Both return_inside(double v, double a, double more) const {
    const Vector2 back{jerk[1], jerk[0]};
    return Both::at_most(directed(a), Vector2{}) |
           Both::at_most(every<Vector2>(a * a), 2 * back * (velocity * more - directed(v)));
  }
};

}  // namespace

profiles_detail::Form profiles_detail::form(const MotionState& from, const MotionState& to,
                                            const Bounds& b) noexcept {
  const Magnitudes m(b);
  const bool steps = b.jerk_max == Bounds::none;
  const Both limits = m.limit(steps);
  const double moves = std::abs(from.velocity) + std::abs(from.acceleration) +
                       std::abs(to.velocity) + std::abs(to.acceleration);
  if (!(std::abs(from.position) + std::abs(to.position) + moves < most)) return Form::any;
  if (moves == 0) {
    if (!limits.hold()) return Form::any;
    if (steps) return Form::second_order;
    if (from.position == to.position) return Form::any;
    return is_even(to.position - from.position, b) ? Form::even_rest : Form::rest_to_rest;
  }
  const Both target = limits & m.hold(to.velocity, to.acceleration, 1 + forgiven);
  if (steps) return target.hold() ? Form::second_order : Form::any;
  const Both sound = target & m.return_inside(to.velocity, -to.acceleration, 1 + forgiven);
  const Both inside = m.hold(from.velocity, from.acceleration, 1) &
                      m.return_inside(from.velocity, from.acceleration, 1);
  if ((sound & inside).hold()) return from == to ? Form::any : Form::point_to_point;
  return sound.hold() ? Form::outside : Form::any;
}

// Each motion is constructed in `out`: a copy would take as long as the solution of a trapezoid.
bool profiles_detail::shortest(Form form, const MotionState& from, const MotionState& to,
                               const Bounds& b, Profile& out) noexcept {
  if (form == Form::point_to_point) {
    ::new (&out) Profile(PointToPoint(from, to, b).shortest(from, to));
  } else if (form == Form::even_rest) {
    ::new (&out) Profile(profile_of(EvenRest(from, to, b).shortest(), b.jerk_max, from, to));
  } else if (form == Form::rest_to_rest) {
    RestToRest move(to.position - from.position, b);
    if (!move.solve_shortest()) return false;
    ::new (&out) Profile(move.profile(from, to));
  } else if (form == Form::second_order) {
    ::new (&out) Profile(shortest_second_order(from, to, b));
  }
  return form > Form::outside;
}

MoveStatus profiles_detail::status_of(const MotionState& from, const MotionState& to,
                                      const Bounds& b) noexcept {
  if (!is_state(from) || !is_state(to)) return MoveStatus::not_finite;
  if (!are_bounds(b)) return MoveStatus::invalid_bounds;
  return target_status(to, b, order_of(b));
}

const char* explain(MoveStatus status) noexcept {
  switch (status) {
    case MoveStatus::ok:
      return "the move exists";
    case MoveStatus::not_finite:
      return "a state or the duration is not finite, or greater than 1e50";
    case MoveStatus::invalid_bounds:
      return "give at least one of velocity, acceleration and jerk; the highest limited derivative "
             "needs a min from -1e50 to -1e-50 and a max from 1e-50 to 1e50";
    case MoveStatus::target_outside:
      return "the target's velocity or acceleration lies outside the bounds";
    case MoveStatus::target_unreachable:
      return "the target's acceleration cannot be reached without a velocity outside the bounds";
    case MoveStatus::position_limit:
      return "no motion from start to target keeps the position limits";
    case MoveStatus::too_short:
      return "the move takes longer than the given duration";
    case MoveStatus::blocked:
      return "a shorter and a longer duration are possible, but this one needs a reversal";
    case MoveStatus::not_straight:
      return "the velocities and accelerations of start and target are not along the line between "
             "them, or an axis would exceed its velocity limit on this line";
    case MoveStatus::wrong_size:
      return "the span of profiles must have one entry for each axis";
  }
  return "";
}

namespace {

/// Makes the result of a solver, which may leave the motion that breaks a position limit in it.
MoveResult& settled(MoveResult& move, const MotionState& from) {
  if (!move) move.profile = Profile({from.position, 0, 0}, 3);
  return move;
}

}  // namespace

const Profile& MoveResult::value() const& {
  if (!*this) throw InputError("move", "", explain(status));
  return profile;
}

Profile MoveResult::value() && {
  return std::as_const(*this).value();
}

MoveResult move_to(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept {
  using profiles_detail::Form;
  const Form form = profiles_detail::form(from, to, bounds);
  if (form == Form::point_to_point)
    return {MoveStatus::ok, profiles_detail::PointToPoint(from, to, bounds).shortest(from, to)};
  if (form == Form::even_rest)
    return {MoveStatus::ok,
            profiles_detail::profile_of(profiles_detail::EvenRest(from, to, bounds).shortest(),
                                        bounds.jerk_max, from, to)};
  if (form == Form::rest_to_rest)
    if (profiles_detail::RestToRest move(to.position - from.position, bounds);
        move.solve_shortest())
      return {MoveStatus::ok, move.profile(from, to)};
  if (form == Form::second_order)
    return {MoveStatus::ok, profiles_detail::shortest_second_order(from, to, bounds)};
  MoveResult move;
  if (form == Form::any) move.status = profiles_detail::status_of(from, to, bounds);
  if (move) move.status = profiles_detail::Solver(from, to, bounds).shortest(move.profile);
  return settled(move, from);
}

MoveResult move_to(const MotionState& from, const MotionState& to, const Bounds& bounds,
                   double duration) noexcept {
  MoveResult move;
  move.status = !std::isfinite(duration) ? MoveStatus::not_finite
                                         : profiles_detail::status_of(from, to, bounds);
  if (!move) return settled(move, from);
  const profiles_detail::Solver solver(from, to, bounds);
  const double minimum = solver.minimum();
  if (duration < minimum * (1 - forgiven))
    move.status = MoveStatus::too_short;
  else if (duration <= minimum * (1 + forgiven))
    move.status = solver.shortest(move.profile);
  else
    move.status = solver.lasting(duration, move.profile);
  // At the edge of a blocked interval, rounding may reject a duration that durations() permits.
  if (move.status == MoveStatus::blocked && solver.durations().allows(duration))
    for (double more = 0; move.status == MoveStatus::blocked && more < forgiven;
         more = 4 * more + 0x1p-52)
      move.status = solver.lasting(duration * (1 + more), move.profile);
  return settled(move, from);
}

Durations durations(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept {
  Durations d;
  d.status = profiles_detail::status_of(from, to, bounds);
  return d.status == MoveStatus::ok ? profiles_detail::Solver(from, to, bounds).durations() : d;
}

MoveResult move_velocity(const MotionState& from, double velocity, const Bounds& bounds,
                         double acceleration) noexcept {
  MoveResult move;
  move.status = profiles_detail::status_of(from, {from.position, velocity, acceleration}, bounds);
  if (move)
    move.status = profiles_detail::to_velocity(from, velocity, acceleration, bounds, move.profile);
  return settled(move, from);
}

bool Durations::allows(double duration) const noexcept {
  return status == MoveStatus::ok && at_least(duration) <= duration * (1 + forgiven);
}

double Durations::at_least(double duration) const noexcept {
  double t = std::max(duration, minimum);
  for (std::size_t i = 0; i < count; ++i)
    if (t > blocked[i].from * (1 + forgiven) && t < blocked[i].to) t = blocked[i].to;
  return t;
}

}  // namespace jounce
