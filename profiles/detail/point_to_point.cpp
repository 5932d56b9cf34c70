#include "jounce/profiles/detail/point_to_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace jounce::detail {
namespace {

constexpr double ulps = 0x1p-49;  // eight units in the last place of whatever it is a share of

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

/// 1/jp, 1/jd and the like of the upward family.
Extremals::Jerks upward_jerks(const Bounds& b) {
  const double per_rise = 1 / b.jerk_max;
  const double per_fall = -1 / b.jerk_min;
  return {per_rise, per_fall, per_rise + per_fall, 1 / (per_rise + per_fall)};
}

/// The natural velocity of an end: where its acceleration a, seen forwards in time from the start
/// and backwards from the target, comes to zero.
double natural(double v, double a, const Extremals::Jerks& j) {
  return v + a * std::abs(a) * (a > 0 ? j.per_fall : j.per_rise) / 2;
}

Extremals mirror_image(const MotionState& from, const MotionState& to, double vmax,
                       const Bounds& b, const Extremals::Jerks& jerks, int degenerate) {
  return {{-from.velocity, -from.acceleration},
          {-to.velocity, -to.acceleration},
          {vmax, -b.acceleration_min, b.acceleration_max},
          jerks.mirrored(),
          degenerate};
}

}  // namespace

PointToPoint::PointToPoint(const MotionState& start, const MotionState& to,
                           const Bounds& bounds) noexcept
    : PointToPoint(snapped(start, to, bounds), to, bounds, upward_jerks(bounds)) {}

PointToPoint::PointToPoint(const MotionState& from, const MotionState& to, const Bounds& bounds,
                           const Extremals::Jerks& jerks) noexcept
    : PointToPoint(from, to, bounds, jerks, natural(from.velocity, from.acceleration, jerks),
                   natural(to.velocity, -to.acceleration, jerks)) {}

// Rounding may have put an end a last digit beyond the velocity limit: that is then the limit. Which
// natural velocity is the greater is asked once, so that both families agree.
PointToPoint::PointToPoint(const MotionState& from, const MotionState& to, const Bounds& b,
                           const Extremals::Jerks& jerks, double n0, double n1) noexcept
    : rise_(b.jerk_max),
      fall_(b.jerk_min),
      d_(to.position - from.position),
      up_({from.velocity, from.acceleration}, {to.velocity, to.acceleration},
          {std::max({b.velocity_max, n0, n1}), b.acceleration_max, -b.acceleration_min}, jerks,
          n0 >= n1 ? 0 : 1),
      down_(mirror_image(from, to, std::max({-b.velocity_min, -n0, -n1}), b, jerks,
                         n0 >= n1 ? 1 : 0)),
      early_(from.acceleration * to.acceleration > 0 && up_.has_early() && down_.has_early()),
      direct_(up_.first(Branch::main)),
      direct_distance_(up_.distance(direct_)) {
  const double t = up_.duration(direct_);
  rounding_ = ulps * (std::abs(from.position) + std::abs(to.position) +
                      t * (std::abs(from.velocity) + std::abs(to.velocity) +
                           t * (std::abs(from.acceleration) + std::abs(to.acceleration))));
}

bool PointToPoint::covered_early(Choice& out) const noexcept {
  out = {true, up_.first(Branch::early)};
  const double direct = up_.distance(out.extremal);
  if (std::abs(d_ - direct) <= rounding_) return true;
  out.upwards = d_ > direct;
  const Extremals& f = family(out.upwards);
  Extremals::Members members;
  if (f.covering(Branch::early, towards(out.upwards), members, 1) == 1) {
    out.extremal = members[0];
    return true;
  }
  out.extremal = f.last_early();
  return std::abs(towards(out.upwards) - f.distance(out.extremal)) <= rounding_;
}

PointToPoint::Choice PointToPoint::fastest() const noexcept {
  Choice c{true, direct_};
  if (early_ && covered_early(c)) return c;
  c = {true, direct_};
  if (std::abs(d_ - direct_distance_) <= rounding_) return c;
  c.upwards = d_ > direct_distance_;
  if (c.upwards) {
    c.extremal = up_.cover(d_, direct_, direct_distance_);
  } else {
    const Extremal begin = down_.first(Branch::main);
    c.extremal = down_.cover(-d_, begin, down_.distance(begin));
  }
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
  return upwards ? std::array{rise_, fall_} : std::array{fall_, rise_};
}

void PointToPoint::append(const Choice& c, Profile& out) const noexcept {
  const auto [rise, fall] = jerks(c.upwards);
  const std::array<double, 7> t = family(c.upwards).phases(c.extremal);
  if (out.phases() == 0) {
    out = Profile(out.start(), out.end(), 3, {rise, fall},
                  {{t[0], 1}, {t[1], 0}, {t[2], 2}, {t[3], 0}, {t[4], 2}, {t[5], 0}, {t[6], 1}});
    return;
  }
  for (std::size_t i = 0; i < 7; ++i)
    out.add(t[i], pattern[i] == 0 ? 0 : (pattern[i] > 0 ? rise : fall));
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
  const bool is_early = early_ && t < up_.duration(direct_);
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
  if (t >= up_.duration(direct_)) return reachable(Branch::main, t);
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
