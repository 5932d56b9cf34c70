#include "jounce/profiles/move.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/brake.hpp"
#include "jounce/profiles/detail/point_to_point.hpp"
#include "jounce/profiles/detail/second_order.hpp"
#include "jounce/profiles/detail/velocity_change.hpp"

namespace jounce {
namespace {

constexpr double forgiven = 1e-12;  // share of a limit that rounding may have added
constexpr double huge = 1e100;      // squares and cubes of what is smaller stay finite

int order_of(const Bounds& b) {
  if (std::isfinite(b.jerk_max)) return 3;
  return std::isfinite(b.acceleration_max) ? 2 : 1;
}

bool is_state(const MotionState& s) {
  return std::abs(s.position) < huge && std::abs(s.velocity) < huge &&
         std::abs(s.acceleration) < huge;
}

bool is_pair(double min, double max) {
  const bool one_sided = std::isfinite(min) != std::isfinite(max);
  return min < 0 && max > 0 && !one_sided;
}

bool are_bounds(const Bounds& b) {
  const bool limited = b.velocity_min < 0 && b.velocity_max > 0 && b.acceleration_min < 0 &&
                       b.acceleration_max > 0 && is_pair(b.jerk_min, b.jerk_max) &&
                       b.position_min < b.position_max;
  const int order = order_of(b);
  if (!limited) return false;
  if (order == 2) return std::isfinite(b.acceleration_min);
  return order == 3 || (std::isfinite(b.velocity_min) && std::isfinite(b.velocity_max) &&
                        std::isinf(b.acceleration_min));
}

MoveStatus target_status(const MotionState& to, const Bounds& b, int order) {
  const auto outside = [](double x, double min, double max) {
    return x < min * (1 + forgiven) || x > max * (1 + forgiven);
  };
  if (order == 1) return MoveStatus::ok;
  if (outside(to.velocity, b.velocity_min, b.velocity_max)) return MoveStatus::target_outside;
  if (order == 2) return MoveStatus::ok;
  if (outside(to.acceleration, b.acceleration_min, b.acceleration_max))
    return MoveStatus::target_outside;
  const double before =
      detail::natural_velocity({to.position, to.velocity, -to.acceleration}, b);
  return outside(before, b.velocity_min, b.velocity_max) ? MoveStatus::target_unreachable
                                                         : MoveStatus::ok;
}

MoveStatus status_of(const MotionState& from, const MotionState& to, const Bounds& b) {
  if (!is_state(from) || !is_state(to)) return MoveStatus::not_finite;
  if (!are_bounds(b)) return MoveStatus::invalid_bounds;
  return target_status(to, b, order_of(b));
}

/// Where the first two orders have no acceleration, and the first no velocity.
MotionState of_order(const MotionState& s, int order) {
  return {s.position, order > 1 ? s.velocity : 0, order > 2 ? s.acceleration : 0};
}

/// Second order: down (or up) to the velocity limit.
MotionState slowed(const MotionState& s, const Bounds& b, Profile& profile) {
  const double v = std::clamp(s.velocity, b.velocity_min, b.velocity_max);
  const double a = v < s.velocity ? b.acceleration_min : b.acceleration_max;
  const double t = (v - s.velocity) / a;
  profile.add(t, a);
  return {s.position + t * (s.velocity + v) / 2, v, 0};
}

/// First order: at constant velocity, in t or as fast as it may be.
double constant_velocity(double d, const Bounds& b) {
  return d / (d > 0 ? b.velocity_max : b.velocity_min);
}

/// One move whose input is sound: the start's way inside, then whichever solver the order asks for.
class Solver {
 public:
  Solver(const MotionState& from, const MotionState& to, const Bounds& b)
      : order_(order_of(b)), bounds_(b), to_(of_order(to, order_)) {
    const MotionState start = of_order(from, order_);
    begun_ = Profile(start, order_);
    inside_ = order_ == 3   ? detail::brought_inside(start, b, begun_)
              : order_ == 2 ? slowed(start, b, begun_)
                            : start;
    begun_.finish(to_);
  }

  [[nodiscard]] Durations durations() const {
    const double before = begun_.duration();
    Durations d;
    if (order_ == 3) d = detail::PointToPoint(inside_, to_, bounds_).durations();
    if (order_ == 2) d = detail::SecondOrder(inside_, to_, bounds_).durations();
    if (order_ == 1) d.minimum = constant_velocity(to_.position - inside_.position, bounds_);
    d.minimum += before;
    for (auto& interval : d.blocked) interval = {interval.from + before, interval.to + before};
    return d;
  }

  [[nodiscard]] Profile shortest() const {
    Profile p = begun_;
    if (inside_ == to_) return p;
    if (order_ == 3) detail::PointToPoint(inside_, to_, bounds_).shortest(p);
    if (order_ == 2) detail::SecondOrder(inside_, to_, bounds_).shortest(p);
    if (order_ == 1) straight(constant_velocity(to_.position - inside_.position, bounds_), p);
    return p;
  }

  [[nodiscard]] Profile lasting(double t) const {
    Profile p = begun_;
    const double rest = t - begun_.duration();
    if (order_ == 3) detail::PointToPoint(inside_, to_, bounds_).lasting(rest, p);
    if (order_ == 2) detail::SecondOrder(inside_, to_, bounds_).lasting(rest, p);
    if (order_ == 1) straight(rest, p);
    return p;
  }

 private:
  void straight(double t, Profile& p) const {
    p.add(t, (to_.position - inside_.position) / t);
  }

  int order_;
  Bounds bounds_;
  MotionState to_, inside_;
  Profile begun_;
};

}  // namespace

const char* explain(MoveStatus status) noexcept {
  switch (status) {
    case MoveStatus::ok: return "the move exists";
    case MoveStatus::not_finite: return "a state is not finite, or greater than 1e100";
    case MoveStatus::invalid_bounds:
      return "every max must be greater and every min less than 0, and the highest derivative that "
             "is limited must be limited in both directions";
    case MoveStatus::target_outside:
      return "the target's velocity or acceleration lies outside the bounds";
    case MoveStatus::target_unreachable:
      return "the target's acceleration cannot be reached without a velocity outside the bounds";
    case MoveStatus::position_limit: return "no motion between the two keeps the position limits";
    case MoveStatus::too_short: return "the move takes longer than that";
    case MoveStatus::blocked:
      return "a shorter and a longer duration are possible, this one is not: the axis would have to "
             "go back";
    case MoveStatus::not_straight:
      return "velocities and accelerations of start and target do not lie on the line between them";
  }
  return "";
}

Move move_to(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept {
  Move move;
  move.status = status_of(from, to, bounds);
  if (move) move.profile = Solver(from, to, bounds).shortest();
  return move;
}

Move move_to(const MotionState& from, const MotionState& to, const Bounds& bounds,
             double duration) noexcept {
  Move move;
  move.status = std::isnan(duration) ? MoveStatus::not_finite : status_of(from, to, bounds);
  if (!move) return move;
  const Solver solver(from, to, bounds);
  const Durations possible = solver.durations();
  if (!possible.allows(duration))
    move.status = duration < possible.minimum ? MoveStatus::too_short : MoveStatus::blocked;
  else
    move.profile = solver.lasting(duration);
  return move;
}

Durations durations(const MotionState& from, const MotionState& to,
                    const Bounds& bounds) noexcept {
  Durations d;
  d.status = status_of(from, to, bounds);
  return d.status == MoveStatus::ok ? Solver(from, to, bounds).durations() : d;
}

Move move_velocity(const MotionState& from, double velocity, const Bounds& bounds,
                   double acceleration) noexcept {
  Move move;
  move.status = status_of(from, {from.position, velocity, acceleration}, bounds);
  if (!move) return move;
  const int order = order_of(bounds);
  const MotionState start = of_order(from, order);
  Profile& p = move.profile;
  p = Profile(start, order);
  MotionState end{start.position, order > 1 ? velocity : 0, 0};
  if (order == 3)
    end = detail::change_velocity(detail::brought_inside(start, bounds, p), velocity, acceleration,
                                  bounds, p);
  if (order == 2) {
    const MotionState inside = slowed(start, bounds, p);
    const double dv = velocity - inside.velocity;
    const double a = dv > 0 ? bounds.acceleration_max : bounds.acceleration_min;
    p.add(dv / a, a);
    end.position = inside.position + dv / a * (inside.velocity + velocity) / 2;
  }
  p.finish(end);
  return move;
}

bool Durations::allows(double duration) const noexcept {
  return at_least(duration) <= duration * (1 + forgiven);
}

double Durations::at_least(double duration) const noexcept {
  double t = std::max(duration, minimum);
  for (std::size_t i = 0; i < count; ++i)
    if (t > blocked[i].from * (1 + forgiven) && t < blocked[i].to) t = blocked[i].to;
  return t;
}

}  // namespace jounce
