#include "jounce/profiles/detail/point_to_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/detail/brake.hpp"

namespace jounce::detail {
namespace {

constexpr double ulps = 0x1p-49;  // eight units in the last place of whatever it is a share of

Bounds mirrored(const Bounds& b) {
  return {-b.velocity_max,     -b.velocity_min, -b.acceleration_max, -b.acceleration_min,
          -b.jerk_max,         -b.jerk_min,     -b.position_max,     -b.position_min};
}

MotionState mirrored(const MotionState& s) {
  return {-s.position, -s.velocity, -s.acceleration};
}

/// The start with the velocity that makes the bare ramp of acceleration meet the target, if only
/// rounding keeps it from that: a motion that has reached its last phase must not begin another.
MotionState snapped(const MotionState& from, const MotionState& to, const Bounds& b) {
  const double a0 = from.acceleration * from.acceleration;
  const double af = to.acceleration * to.acceleration;
  const double jerk = to.acceleration > from.acceleration ? b.jerk_max : b.jerk_min;
  const double ramp = (af - a0) / (2 * jerk);
  const double scale = std::abs(from.velocity) + std::abs(to.velocity) + (a0 + af) / std::abs(jerk);
  MotionState s = from;
  if (std::abs(to.velocity - from.velocity - ramp) <= ulps * scale) s.velocity = to.velocity - ramp;
  return s;
}

/// The natural velocities of start and target: where the acceleration comes to zero, or came from.
std::array<double, 2> natural(const MotionState& from, const MotionState& to, const Bounds& b) {
  return {natural_velocity(from, b),
          natural_velocity({to.position, to.velocity, -to.acceleration}, b)};
}

Extremals between(const MotionState& from, const MotionState& to, const Bounds& b,
                  int degenerate) {
  // Rounding may have put an end a last digit beyond the limit.
  const auto n = natural(from, to, b);
  const double vmax = std::max({b.velocity_max, n[0], n[1]});
  return {{from.velocity, from.acceleration},
          {to.velocity, to.acceleration},
          {vmax, b.acceleration_max, -b.acceleration_min, b.jerk_max, -b.jerk_min},
          degenerate};
}

/// Which end has the greater natural velocity: asked once, so that both families agree.
int higher(const MotionState& from, const MotionState& to, const Bounds& b) {
  const auto n = natural(from, to, b);
  return n[0] >= n[1] ? 0 : 1;
}

}  // namespace

PointToPoint::PointToPoint(const MotionState& from, const MotionState& to,
                           const Bounds& bounds) noexcept
    : from_(snapped(from, to, bounds)),
      to_(to),
      bounds_(bounds),
      d_(to.position - from.position),
      up_(between(from_, to_, bounds, higher(from_, to_, bounds))),
      down_(between(mirrored(from_), mirrored(to_), mirrored(bounds),
                    1 - higher(from_, to_, bounds))),
      early_(up_.has_early() && down_.has_early()) {
  const double t = up_.duration(up_.first(Branch::main));
  rounding_ = ulps * (std::abs(from.position) + std::abs(to.position) +
                      t * (std::abs(from.velocity) + std::abs(to.velocity)) +
                      t * t * (std::abs(from.acceleration) + std::abs(to.acceleration)));
}

bool PointToPoint::covered(Branch b, Choice& out) const noexcept {
  out = {true, up_.first(b)};
  const double direct = up_.distance(out.extremal);
  if (std::abs(d_ - direct) <= rounding_) return true;
  out.upwards = d_ > direct;
  if (b == Branch::main) {
    out.extremal = family(out.upwards).cover(towards(out.upwards));
    return true;
  }
  Extremals::Members members;
  if (family(out.upwards).covering(b, towards(out.upwards), members, 1) == 1) {
    out.extremal = members[0];
    return true;
  }
  out.extremal = family(out.upwards).last_early();
  return std::abs(towards(out.upwards) - family(out.upwards).distance(out.extremal)) <= rounding_;
}

PointToPoint::Choice PointToPoint::fastest() const noexcept {
  Choice c;
  if (early_ && covered(Branch::early, c)) return c;
  (void)covered(Branch::main, c);
  return c;
}

double PointToPoint::minimum() const noexcept {
  const Choice c = fastest();
  return family(c.upwards).duration(c.extremal);
}

namespace {

/// Of the phases of an extremal: whether the jerk is that of rise, of fall, or none.
constexpr std::array<int, 7> pattern{1, 0, -1, 0, -1, 0, 1};

}  // namespace

/// The jerks of a family's phases, real ones: of rise, of fall.
std::array<double, 2> PointToPoint::jerks(bool upwards) const noexcept {
  return upwards ? std::array{bounds_.jerk_max, bounds_.jerk_min}
                 : std::array{bounds_.jerk_min, bounds_.jerk_max};
}

void PointToPoint::append(const Choice& c, Profile& out) const noexcept {
  const auto [rise, fall] = jerks(c.upwards);
  const std::array<double, 7> durations = family(c.upwards).phases(c.extremal);
  for (std::size_t i = 0; i < 7; ++i)
    out.add(durations[i], pattern[i] == 0 ? 0 : (pattern[i] > 0 ? rise : fall));
}

void PointToPoint::append_blend(const Choice& a, const Choice& b, double share,
                                Profile& out) const noexcept {
  // Bounds are convex: what two motions of one duration keep, their mean keeps.
  const std::array<std::array<double, 7>, 2> phases{family(a.upwards).phases(a.extremal),
                                                    family(b.upwards).phases(b.extremal)};
  std::array<std::array<double, 3>, 2> jerk;  // of -, 0, +
  for (std::size_t k = 0; k < 2; ++k) {
    const auto [rise, fall] = jerks(k == 0 ? a.upwards : b.upwards);
    const double weight = k == 0 ? share : 1 - share;
    jerk[k] = {weight * fall, 0, weight * rise};
  }
  std::array<std::size_t, 2> at{0, 0};
  std::array<double, 2> left{phases[0][0], phases[1][0]};
  while (at[0] < 7 && at[1] < 7) {
    const double step = std::max(std::min(left[0], left[1]), 0.0);
    out.add(step, jerk[0][static_cast<std::size_t>(pattern[at[0]] + 1)],
            jerk[1][static_cast<std::size_t>(pattern[at[1]] + 1)]);
    for (std::size_t k = 0; k < 2; ++k) {
      left[k] -= step;
      while (at[k] < 7 && left[k] <= 0)
        if (++at[k] < 7) left[k] = phases[k][at[k]];
    }
  }
}

void PointToPoint::shortest(Profile& out) const noexcept {
  append(fastest(), out);
}

void PointToPoint::lasting(double t, Profile& out) const noexcept {
  const Choice fast = fastest();
  if (t <= family(fast.upwards).duration(fast.extremal) * (1 + ulps)) return append(fast, out);
  const bool is_early = early_ && t < up_.duration(up_.first(Branch::main));
  const Branch b = is_early ? Branch::early : Branch::main;
  std::array<Choice, 2> ends;
  std::array<double, 2> reach;
  for (std::size_t i = 0; i < 2; ++i) {
    Choice& c = ends[i];
    c.upwards = i == 0;
    const Extremals& f = family(c.upwards);
    const Extremal level = f.level();
    const double spare = t - f.duration(level);
    if (is_early || spare <= 0) {
      c.extremal = f.lasting(b, t);
    } else {
      c.extremal = level;
      c.extremal.cruise = spare;
      if (f.distance(c.extremal) < towards(c.upwards))
        return append({c.upwards, f.cruising(t, towards(c.upwards))}, out);
    }
    reach[i] = (c.upwards ? 1 : -1) * f.distance(c.extremal);
  }
  const double width = reach[0] - reach[1];
  const double share = width > 0 ? std::clamp((d_ - reach[1]) / width, 0.0, 1.0) : 0.5;
  append_blend(ends[0], ends[1], share, out);
}

bool PointToPoint::reachable(double t) const noexcept {
  if (t >= up_.duration(up_.first(Branch::main))) return reachable(Branch::main, t);
  return early_ && t <= up_.duration(up_.last_early()) && reachable(Branch::early, t);
}

bool PointToPoint::reachable(Branch b, double t) const noexcept {
  return up_.distance(up_.lasting(b, t)) >= d_ - rounding_ &&
         -down_.distance(down_.lasting(b, t)) <= d_ + rounding_;
}

Durations PointToPoint::durations() const noexcept {
  Durations out;
  out.minimum = minimum();
  // Between these instants nothing changes about whether the target can be reached.
  std::array<double, 16> event{out.minimum};
  std::size_t n = 1;
  for (const Branch b : {Branch::early, Branch::main}) {
    if (b == Branch::early && !early_) continue;
    event[n++] = up_.duration(up_.first(b));
    if (b == Branch::early) event[n++] = up_.duration(up_.last_early());
    for (const bool upwards : {true, false}) {
      Extremals::Members members;
      const int found = family(upwards).covering(b, towards(upwards), members);
      for (int i = 0; i < found; ++i)
        event[n++] = family(upwards).duration(members[static_cast<std::size_t>(i)]);
    }
  }
  std::sort(event.begin(), event.begin() + n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double from = std::max(event[i], out.minimum);
    const double to = event[i + 1];
    if (!(to > from * (1 + ulps))) continue;
    const double middle = from + (to - from) / 2;
    if (reachable(middle)) continue;
    if (out.count > 0 && out.blocked[out.count - 1].to == from)
      out.blocked[out.count - 1].to = to;
    else if (out.count < out.blocked.size())
      out.blocked[out.count++] = {from, to};
  }
  return out;
}

}  // namespace jounce::detail
