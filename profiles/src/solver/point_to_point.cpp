// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/point_to_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

#include "jounce/profiles/detail/numeric.hpp"

#include "profiles/src/solver/velocity_change.hpp"

namespace jounce::profiles_detail {
namespace {

/// 1/jp, 1/jd and their combinations, for the upward family.
Extremals::Jerks upward_jerks(const Bounds& b) {
  const double per_rise = 1 / b.jerk_max;
  const double per_fall = -1 / b.jerk_min;
  const double per_k = b.jerk_max / (b.jerk_max - b.jerk_min) * -b.jerk_min;
  return {per_rise, per_fall, per_rise + per_fall, per_k};
}

/// The target's velocity minus the start's. If they differ only by rounding, it is the change by
/// the ramp of acceleration alone, because a motion in its last phase must not begin another phase.
double velocity_difference(const MotionState& from, const MotionState& to,
                           const Extremals::Jerks& j) {
  const double a0 = from.acceleration;
  const double af = to.acceleration;
  const double dv = to.velocity - from.velocity;
  const double ramp = std::abs(af - a0) * (af + a0) * (af > a0 ? j.per_rise : j.per_fall) / 2;
  // For very different jerks uses the greater one, because it corrects the rounding error of the
  // velocity.
  const double scale = std::abs(from.velocity) + std::abs(to.velocity) +
                       2 * (a0 * a0 + af * af) * std::min(j.per_rise, j.per_fall);
  return std::abs(dv - ramp) <= profiles_detail::rounding * scale ? ramp : dv;
}

/// The natural velocity of an end minus its velocity. From the acceleration a (forwards in time
/// from the start, backwards from the target), the acceleration returns to zero at the natural
/// velocity.
double to_natural(double a, const Extremals::Jerks& j) {
  return a * std::abs(a) * (a > 0 ? j.per_fall : j.per_rise) / 2;
}

}  // namespace

void block(const Durations::Interval& interval, Durations& out) noexcept {
  const bool goes_on = out.count > 0 && out.blocked[out.count - 1].to == interval.from;
  if (goes_on || out.count == out.blocked.size())
    out.blocked[out.count - 1].to = interval.to;
  else
    out.blocked[out.count++] = interval;
}

PointToPoint::PointToPoint(const MotionState& from, const MotionState& to,
                           const Bounds& bounds) noexcept
    : PointToPoint(from, to, bounds, upward_jerks(bounds)) {}

// By rounding, an end may exceed the velocity limit by a last digit; then its velocity becomes the
// limit. The natural velocities are compared only once, so that both families agree.
PointToPoint::PointToPoint(const MotionState& from, const MotionState& to, const Bounds& b,
                           const Extremals::Jerks& jerks) noexcept
    : rise_(b.jerk_max),
      fall_(b.jerk_min),
      d_(to.position - from.position),
      dv_(velocity_difference(from, to, jerks)),
      from_{dv_ == to.velocity - from.velocity ? from.velocity : to.velocity - dv_,
            from.acceleration},
      to_{to.velocity, to.acceleration},
      jerks_(jerks) {
  const double to_start = to_natural(from.acceleration, jerks);
  const double to_target = to_natural(-to.acceleration, jerks);
  natural_ = {from_.velocity + to_start, to_.velocity + to_target};
  start_is_higher_ = (from_.velocity - to_.velocity) + (to_start - to_target) >= 0;
  up_limits_ = {std::max({b.velocity_max, natural_[0], natural_[1]}), b.acceleration_max,
                -b.acceleration_min};
  down_limits_ = {std::max({-b.velocity_min, -natural_[0], -natural_[1]}), -b.acceleration_min,
                  b.acceleration_max};
  scale_ = {std::abs(from.position) + std::abs(to.position),
            std::abs(from.velocity) + std::abs(to.velocity),
            std::abs(from.acceleration) + std::abs(to.acceleration)};
}

/// The rounding error of a distance that is covered in the time t.
double PointToPoint::rounding(double t) const noexcept {
  return profiles_detail::rounding *
         (scale_.position + t * (scale_.velocity + t * scale_.acceleration));
}

Extremals PointToPoint::family(bool upwards) const noexcept {
  if (upwards) return {from_, to_, dv_, up_limits_, jerks_, start_is_higher_ ? 0 : 1};
  return {{-from_.velocity, -from_.acceleration},
          {-to_.velocity, -to_.acceleration},
          -dv_,
          down_limits_,
          jerks_.mirrored(),
          start_is_higher_ ? 1 : 0};
}

/// True if an early branch is possible.
bool PointToPoint::is_early(const Extremals& up) const noexcept {
  return from_.acceleration * to_.acceleration > 0 && up.has_early();
}

PointToPoint::Families PointToPoint::families() const noexcept {
  Families both{family(true), family(false), false};
  both.early = is_early(both.up) && both.down.has_early();
  return both;
}

bool PointToPoint::fastest_early(const Extremals& up, Course& out) const noexcept {
  if (!is_early(up)) return false;
  const Extremals down = family(false);
  if (!down.has_early()) return false;
  const Extremal first = up.first(Branch::early);
  const double direct = up.distance(first);
  out = {true, up.phases(first)};
  // This branch may be much shorter than the direct change of the main branch.
  const double known = rounding(up.duration(first));
  if (std::abs(d_ - direct) <= known) return true;
  out.upwards = d_ > direct;
  const Extremals& f = out.upwards ? up : down;
  Extremals::Members members{f.last_early()};
  const double reach = f.distance(members[0]);
  const bool covered = f.covering(Branch::early, towards(out.upwards), members, 1) == 1;
  out.phases = f.phases(members[0]);
  return covered || std::abs(towards(out.upwards) - reach) <= known;
}

PointToPoint::Course PointToPoint::fastest() const noexcept {
  const Extremals up = family(true);
  Course c;
  if (fastest_early(up, c)) return c;
  const Extremal direct = up.first(Branch::main);
  const double covered = up.distance(direct);
  const double excess = d_ - covered;
  if (std::abs(excess) <= rounding(up.duration(direct))) return {true, up.phases(direct)};
  if (excess > 0) return {true, up.phases(up.cover(d_, direct, covered))};
  const Extremals down = family(false);
  return {false, down.phases(down.cover(-d_, up.mirrored(direct), -covered))};
}

double PointToPoint::minimum() const noexcept {
  double t = 0;
  for (const double phase : fastest().phases) t += std::max(phase, 0.0);
  return t;
}

namespace {

/// The jerk in the phases of an extremal: of the rise (1), of the fall (-1), or none (0).
constexpr std::array<int, 7> pattern{1, 0, -1, 0, -1, 0, 1};

}  // namespace

/// The signed jerks of a family's phases: of the rise, and of the fall.
std::array<double, 2> PointToPoint::jerks(bool upwards) const noexcept {
  return {either(upwards, rise_, fall_), either(upwards, fall_, rise_)};
}

Profile PointToPoint::shortest(const MotionState& from, const MotionState& to) const noexcept {
  return profile(fastest(), from, to);
}

Profile PointToPoint::profile(const Course& c, const MotionState& from,
                              const MotionState& to) const noexcept {
  const auto [rise, fall] = jerks(c.upwards);
  const auto& t = c.phases;
  return Profile(from, to, 3, {rise, fall},
                 {{t[0], 1}, {t[1], 0}, {t[2], 2}, {t[3], 0}, {t[4], 2}, {t[5], 0}, {t[6], 1}});
}

void PointToPoint::append(const Course& c, Profile& out) const noexcept {
  if (out.phases() == 0) {
    ::new (&out) Profile(profile(c, MotionState(out.start()), MotionState(out.end())));
    return;
  }
  const auto [rise, fall] = jerks(c.upwards);
  for (std::size_t i = 0; i < 7; ++i)
    out.add(c.phases[i], pattern[i] == 0 ? 0 : (pattern[i] > 0 ? rise : fall));
}

/// Appends `share` of one motion plus the rest of another one of the same duration. Bounds are
/// convex: if both motions keep them, so does their weighted mean.
void PointToPoint::append_blend(const std::array<Course, 2>& c, double share,
                                Profile& out) const noexcept {
  const std::array<double, 2> weight{share, 1 - share};
  // The phases have whole jerks up to here; they are written as sums of the same parts.
  Profile whole(out.start(), 3);
  whole.finish(out.end());
  for (std::size_t i = 0; i < out.phases(); ++i) {
    const auto f = out.phase(i);
    whole.add(f.duration, weight[0] * f.value, weight[1] * f.value);
  }
  std::array<std::array<double, 3>, 2> jerk;  // for -, 0, +
  for (std::size_t k = 0; k < 2; ++k) {
    const auto [rise, fall] = jerks(c[k].upwards);
    jerk[k] = {weight[k] * fall, 0, weight[k] * rise};
  }
  // By rounding, one motion may end a little before the other; its jerk is then 0.
  std::array<std::size_t, 2> at{0, 0};
  std::array<double, 2> left{c[0].phases[0], c[1].phases[0]};
  while (at[0] < 7 || at[1] < 7) {
    const double step = std::max(std::min(left[0], left[1]), 0.0);
    const auto value = [&](std::size_t k) {
      return at[k] < 7 ? jerk[k][static_cast<std::size_t>(pattern[at[k]] + 1)] : 0;
    };
    whole.add(step, value(0), value(1));
    for (std::size_t k = 0; k < 2; ++k) {
      if (at[k] == 7) continue;
      left[k] -= step;
      while (at[k] < 7 && left[k] <= 0)
        left[k] = ++at[k] < 7 ? c[k].phases[at[k]] : std::numeric_limits<double>::infinity();
    }
  }
  out = whole;
}

/// The bounds for a change of velocity.
Bounds PointToPoint::ramps() const noexcept {
  return {.acceleration_min = -down_limits_.rise,
          .acceleration_max = down_limits_.fall,
          .jerk_min = fall_,
          .jerk_max = rise_};
}

/// For profiles that already have phases, and for durations that are long compared with the changes
/// at the ends.
bool PointToPoint::append_long(double t, Profile& out) const noexcept {
  const VelocityChange direct({0, from_.velocity, from_.acceleration}, to_.velocity,
                              to_.acceleration, ramps());
  return (out.phases() > 0 || t > 8 * direct.duration()) && append_stair(t, out);
}

/// A motion that cruises at a velocity between those of both ends, if there is time for that. It
/// has fewer phases than the mean of two motions, and each phase has its own length. (Beside long
/// phases, the ends of short ones would lose their digits.)
bool PointToPoint::append_stair(double t, Profile& out) const noexcept {
  const Bounds bounds = ramps();
  const MotionState start{0, from_.velocity, from_.acceleration};
  VelocityChange first;
  VelocityChange second;
  double cruise = 0;
  // The distance increases with the velocity, at the rate `slope`.
  const auto covered = [&](double velocity, double& slope) {
    first = VelocityChange(start, velocity, 0, bounds);
    second = VelocityChange({0, velocity, 0}, to_.velocity, to_.acceleration, bounds);
    cruise = t - first.duration() - second.duration();
    slope = cruise + (first.last() + second.first()) / 2;
    return first.distance() + second.distance() + velocity * cruise;
  };
  double low = std::min(natural_[0], natural_[1]);
  double high = std::max(natural_[0], natural_[1]);
  double velocity = std::clamp(d_ / t, low, high);
  for (int i = 0; i < 100; ++i) {
    double slope = t;
    const double excess = covered(velocity, slope) - d_;
    if (!(cruise >= 0)) return false;
    (excess < 0 ? low : high) = velocity;
    double next = velocity - excess / slope;
    if (!(next > low && next < high) || i > 20) next = low + (high - low) / 2;
    if (excess == 0 || !(next > low && next < high) || next == velocity) break;
    velocity = next;
  }
  constexpr std::size_t most = 7;
  if (out.phases() + most > Profile::capacity) return false;
  first.append(out);
  out.add(cruise, 0);
  second.append(out);
  return true;
}

bool PointToPoint::append_mean(const std::array<Course, 2>& ends,
                               const std::array<double, 2>& reach, Profile& out) const noexcept {
  const double width = reach[0] - reach[1];
  const double share = width > 0 ? std::clamp((d_ - reach[1]) / width, 0.0, 1.0) : 0.5;
  append_blend(ends, share, out);
  return true;
}

bool PointToPoint::cruises(double t, Profile& out) const noexcept {
  const double least = 0x1p-20 * t;
  std::array<Course, 2> ends;
  std::array<double, 2> reach;
  // Usually only one family has the solution: tries the more probable one first.
  const bool rises = d_ >= t * (natural_[0] + natural_[1]) / 2;
  for (const bool upwards : {rises, !rises}) {
    const Extremals f = family(upwards);
    const double d = towards(upwards);
    Extremal e;
    double covered = 0;
    if (d <= t * f.natural()) {  // otherwise it cruises above this velocity
      e = f.level();
      e.cruise = t - f.duration(e);
      if (!(e.cruise > least)) return false;
      covered = f.distance(e);
    }
    if (d > t * f.natural() || covered < d) {
      if (!f.soon_cruising(t, d, e) || !(e.cruise > least)) return false;
      append({upwards, f.phases(e)}, out);
      return true;
    }
    const std::size_t i = upwards ? 0 : 1;
    ends[i] = {upwards, f.phases(e)};
    reach[i] = upwards ? covered : -covered;
  }
  return append_long(t, out) || append_mean(ends, reach, out);
}

bool PointToPoint::lasting(double t, Profile& out) const noexcept {
  if (cruises(t, out)) return true;
  const Families both = families();
  const double main = both.up.duration(both.up.first(Branch::main));
  const bool is_early =
      both.early && t < main &&
      t <= both.up.duration(both.up.last_early()) * (1 + profiles_detail::rounding);
  if (!is_early && t < main * (1 - profiles_detail::rounding)) return false;
  // At the edge of a blocked interval, both sides have rounding errors, also that of the change by
  // the accelerations at the ends.
  const double per_jerk = std::min(jerks_.per_rise, jerks_.per_fall);
  const double slack = 3 * (rounding(t) + profiles_detail::rounding * std::abs(d_)) +
                       profiles_detail::rounding * cube(scale_.acceleration) * square(per_jerk);
  std::array<Course, 2> ends;
  std::array<double, 2> reach;
  for (const bool upwards : {true, false}) {
    const Extremals& f = both.of(upwards);
    Extremal e = f.level();
    const double spare = t - f.duration(e);
    if (is_early || spare <= 0) {
      e = f.lasting(is_early ? Branch::early : Branch::main, t);
    } else {
      e.cruise = spare;
      if (f.distance(e) < towards(upwards)) {
        if (!f.cruising(t, towards(upwards), slack, e)) return false;
        append({upwards, f.phases(e)}, out);
        return true;
      }
    }
    const std::size_t i = upwards ? 0 : 1;
    ends[i] = {upwards, f.phases(e)};
    reach[i] = (upwards ? 1 : -1) * f.distance(e);
  }
  if (reach[0] < d_ - slack || reach[1] > d_ + slack) return false;
  return append_long(t, out) || append_mean(ends, reach, out);
}

bool PointToPoint::reachable(const Families& both, double t) const noexcept {
  const Extremals& up = both.up;
  const bool is_main = t >= up.duration(up.first(Branch::main));
  if (!is_main && !(both.early && t <= up.duration(up.last_early()))) return false;
  const Branch b = is_main ? Branch::main : Branch::early;
  const double slack = rounding(t) + profiles_detail::rounding * std::abs(d_);
  return up.distance(up.lasting(b, t)) >= d_ - slack &&
         -both.down.distance(both.down.lasting(b, t)) <= d_ + slack;
}

void PointToPoint::add_events(Branch b, const Families& both, Events& events) const noexcept {
  events.add(both.up.duration(both.up.first(b)));
  if (b == Branch::early) events.add(both.up.duration(both.up.last_early()));
  for (const bool upwards : {true, false}) {
    const Extremals& f = both.of(upwards);
    Extremals::Members members;
    const int found = f.covering(b, towards(upwards), members);
    for (int i = 0; i < found; ++i) events.add(f.duration(members[static_cast<std::size_t>(i)]));
  }
}

/// Adds the impossible durations after the minimum, one interval between each pair of events.
template <class Possible>
void PointToPoint::find_blocked(Events events, Durations& out, Possible possible) noexcept {
  std::sort(events.at.begin(), events.at.begin() + events.count);
  for (std::size_t i = 0; i + 1 < events.count; ++i) {
    const double from = std::max(events.at[i], out.minimum);
    const double to = events.at[i + 1];
    if (!(to > from * (1 + profiles_detail::rounding)) || possible(from + (to - from) / 2))
      continue;
    block({from, to}, out);
  }
}

Durations PointToPoint::durations() const noexcept {
  Durations out;
  out.minimum = minimum();
  const Families both = families();
  Events events;
  events.add(out.minimum);
  if (both.early) add_events(Branch::early, both, events);
  add_events(Branch::main, both, events);
  find_blocked(events, out, [&](double t) { return reachable(both, t); });
  return out;
}

bool PointToPoint::has_early() const noexcept {
  Course course;
  return fastest_early(family(true), course);
}

Durations PointToPoint::early_durations() const noexcept {
  Durations out;
  out.minimum = minimum();
  const Families both = families();
  const double last = both.up.duration(both.up.last_early());
  Events events;
  events.add(out.minimum);
  add_events(Branch::early, both, events);
  events.add(std::numeric_limits<double>::infinity());
  find_blocked(events, out, [&](double t) { return t <= last && reachable(both, t); });
  return out;
}

}  // namespace jounce::profiles_detail
