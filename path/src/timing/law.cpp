// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "path/src/timing/stretch.hpp"

namespace jounce {
namespace {

struct Builder {
  std::span<LawPhase, 7> out;
  std::size_t count = 0;
  LawPhase now{};  ///< state at the end of the last phase

  void add(double duration, double jerk) {
    if (!(duration > 0)) return;
    now.duration = duration;
    now.jerk = jerk;
    out[count++] = now;
    const double t = duration;
    now.position += t * (now.velocity + t * (now.acceleration / 2 + t * jerk / 6));
    now.velocity += t * (now.acceleration + t * jerk / 2);
    now.acceleration += t * jerk;
  }

  /// Appends a ramp to a velocity. It begins and ends without acceleration, except if the jerk is
  /// not limited.
  void ramp(double to, double limit, double jerk) {
    const double dv = std::abs(to - now.velocity);
    const double sign = to < now.velocity ? -1 : 1;
    if (std::isinf(jerk)) {
      now.acceleration = sign * limit;
      add(dv / limit, 0);
    } else {
      const bool reaches = dv * jerk > limit * limit;
      const double edge = reaches ? limit / jerk : std::sqrt(dv / jerk);
      add(edge, sign * jerk);
      if (reaches) now.acceleration = sign * limit;
      if (reaches) add(dv / limit - edge, 0);
      add(edge, -sign * jerk);
    }
    now.velocity = to;
    now.acceleration = 0;
  }
};

}  // namespace

std::size_t phases(const LawStretch& stretch, std::span<LawPhase, 7> out) {
  Builder builder{out};
  builder.now.velocity = stretch.v0;
  if (stretch.pieces == 0) {
    builder.add(stretch.duration, 0);
    return builder.count;
  }
  if (stretch.single_phase) {
    out[0] = {stretch.duration, 0, stretch.v0, stretch.acceleration, stretch.jerk};
    return 1;
  }
  const double down = ramp_distance(stretch.peak, stretch.v1, stretch.deceleration, stretch.jerk);
  builder.ramp(stretch.peak, stretch.acceleration, stretch.jerk);
  const double cruise = stretch.length - builder.now.position - down;
  // A remainder within rounding is not a cruise.
  if (cruise > 1e-14 * stretch.length) builder.add(cruise / stretch.peak, 0);
  builder.ramp(stretch.v1, stretch.deceleration, stretch.jerk);
  // The phases cover the length except for rounding. Distances and durations are multiplied to
  // correct this; velocities stay.
  const double factor = stretch.length / builder.now.position;
  for (LawPhase& phase : out.first(builder.count)) {
    phase.duration *= factor;
    phase.position *= factor;
    phase.acceleration /= factor;
    phase.jerk /= factor * factor;
  }
  return builder.count;
}

TimingLaw::TimingLaw(std::vector<LawStretch> stretches) : stretches_(std::move(stretches)) {
  assert(!stretches_.empty());
}

double TimingLaw::duration() const {
  return stretches_.back().time + stretches_.back().duration;
}

std::size_t TimingLaw::stretch_at(double t) const {
  const auto it = std::upper_bound(stretches_.begin() + 1, stretches_.end(), t,
                                   [](double x, const LawStretch& s) { return x < s.time; });
  return static_cast<std::size_t>(it - stretches_.begin()) - 1;
}

Motion motion_of(std::span<const LawPhase> phases, double t) {
  if (phases.empty()) return {};
  std::size_t i = 0;
  while (i + 1 < phases.size() && t >= phases[i].duration) t -= phases[i++].duration;
  const LawPhase& p = phases[i];
  t = std::clamp(t, 0.0, p.duration);
  return {p.position + t * (p.velocity + t * (p.acceleration / 2 + t * p.jerk / 6)),
          p.velocity + t * (p.acceleration + t * p.jerk / 2), p.acceleration + t * p.jerk, p.jerk};
}

Motion motion_in(const LawStretch& stretch, double t) {
  std::array<LawPhase, 7> phase;
  return motion_of(std::span(phase).first(phases(stretch, phase)), t);
}

Motion TimingLaw::at(double t) const {
  const LawStretch& stretch = stretches_[stretch_at(t)];
  Motion m = motion_in(stretch, t - stretch.time);
  m.position = std::min(m.position, stretch.length) + stretch.start;
  return m;
}

Segment segment_of(const LawPhase& phase) {
  const double t = phase.duration;
  Segment f;
  f.length = t;
  f.c[0] = phase.position;
  f.c[1] = phase.velocity * t;
  f.c[2] = phase.acceleration * t * t / 2;
  f.c[3] = phase.jerk * t * t * t / 6;
  f.degree = phase.jerk != 0 ? 3 : phase.acceleration != 0 ? 2 : 1;
  return f;
}

Trajectory TimingLaw::curve() const {
  std::vector<Segment> segments;
  std::array<LawPhase, 7> phase;
  for (const LawStretch& stretch : stretches_)
    for (const LawPhase& p : std::span(phase).first(phases(stretch, phase)))
      segments.push_back(scaled(segment_of(p), 1, stretch.start));
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

double ramp_time(double dv, double acceleration, double jerk) {
  if (std::isinf(jerk)) return dv / acceleration;
  return dv * jerk > acceleration * acceleration ? dv / acceleration + acceleration / jerk
                                                 : 2 * std::sqrt(dv / jerk);
}

double ramp_distance(double v0, double v1, double acceleration, double jerk) {
  return 0.5 * (v0 + v1) * ramp_time(std::abs(v1 - v0), acceleration, jerk);
}

}  // namespace jounce
