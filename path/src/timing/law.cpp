// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "jounce/profiles/detail/large_pages.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/timing/stretch.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_value;

/// A ramp between two velocities: two edges with the jerk, and the part between them.
struct RampParts {
  double edge = 0;       ///< s
  double flat = 0;       ///< s
  double time = 0;       ///< s, the whole ramp: ramp_time()
  bool reaches = false;  ///< true: the ramp reaches the limit of acceleration

  RampParts(double dv, double limit, double jerk) {
    if (std::isinf(jerk)) {
      time = flat = dv / limit;
      reaches = true;
    } else if (dv * jerk > limit * limit) {
      reaches = true;
      edge = limit / jerk;
      const double ramp = dv / limit;
      flat = ramp - edge;
      time = ramp + edge;
    } else {
      edge = std::sqrt(dv / jerk);
      time = 2 * edge;
    }
  }
};

/// Phases without initial values: to zero them would take a tenth of the time of an evaluation.
union PhaseBuffer {
  std::array<LawPhase, 7> phases;
  PhaseBuffer() {}  // NOLINT(modernize-use-equals-default): a defaulted one would be deleted
};

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
  void ramp(double to, const RampParts& parts, double limit, double jerk) {
    const double sign = to < now.velocity ? -1 : 1;
    add(parts.edge, sign * jerk);
    if (parts.reaches) {
      now.acceleration = sign * limit;
      add(parts.flat, 0);
    }
    add(parts.edge, -sign * jerk);
    now.velocity = to;
    now.acceleration = 0;
  }
};

/// Phases that cover the length but for rounding: durations and distances are multiplied by `factor`, velocities stay.
struct Unscaled {
  std::size_t count = 0;
  double factor = 1;
};

LawPhase scaled(LawPhase phase, double factor) {
  phase.duration *= factor;
  phase.position *= factor;
  phase.acceleration /= factor;
  phase.jerk /= factor * factor;
  return phase;
}

/// True for a stretch at constant velocity.
bool cruises(const LawInterval& stretch) {
  return stretch.v0 == stretch.peak && stretch.v1 == stretch.peak && stretch.peak > 0 &&
         stretch.pieces > 0 && !stretch.is_phase();
}

Unscaled unscaled_phases(const LawInterval& stretch, std::span<LawPhase, 7> out) {
  Builder builder{out};
  builder.now.velocity = stretch.v0;
  if (stretch.pieces == 0) {
    builder.add(stretch.duration, 0);
    return {builder.count, 1};
  }
  if (stretch.is_phase()) {
    out[0] = {stretch.duration, 0, stretch.v0, stretch.acceleration, stretch.jerk};
    return {1, 1};
  }
  if (cruises(stretch)) {
    builder.add(stretch.length / stretch.peak, 0);
    return {builder.count, stretch.length / builder.now.position};
  }
  const RampParts rise(stretch.peak - stretch.v0, stretch.acceleration, stretch.jerk);
  const RampParts fall(stretch.peak - stretch.v1, stretch.deceleration, stretch.jerk);
  builder.ramp(stretch.peak, rise, stretch.acceleration, stretch.jerk);
  const double down = 0.5 * (stretch.peak + stretch.v1) * fall.time;
  const double cruise = stretch.length - builder.now.position - down;
  // A rest within rounding is no cruise.
  if (cruise > rounded_value * stretch.length) builder.add(cruise / stretch.peak, 0);
  builder.ramp(stretch.v1, fall, stretch.deceleration, stretch.jerk);
  return {builder.count, stretch.length / builder.now.position};
}

/// Motion t after the start of a phase.
Motion motion_of(const LawPhase& p, double t) {
  t = std::clamp(t, 0.0, p.duration);
  return {p.position + t * (p.velocity + t * (p.acceleration / 2 + t * p.jerk / 6)),
          p.velocity + t * (p.acceleration + t * p.jerk / 2), p.acceleration + t * p.jerk, p.jerk};
}

}  // namespace

std::size_t phases(const LawInterval& stretch, std::span<LawPhase, 7> out) {
  const auto [count, factor] = unscaled_phases(stretch, out);
  for (LawPhase& phase : out.first(count)) phase = scaled(phase, factor);
  return count;
}

TimingLaw::TimingLaw(LawStretches stretches) : stretches_(std::move(stretches)) {
  assert(!stretches_.empty());
  constexpr std::size_t most = std::numeric_limits<decltype(LawStretches::Block::data)>::max();
  if (stretches_.numbers() > most)
    throw InputError("program", std::to_string(stretches_.numbers()) + " numbers",
                     "must need at most " + std::to_string(most) +
                         " numbers for its velocities: divide the program");
  stretches_.shrink();
  const std::span<const LawStretches::Block> blocks = stretches_.blocks_;
  const std::size_t parts = blocks.size();
  parts_per_second_ = static_cast<double>(parts) / duration();
  profiles_detail::reserve_large(before_, parts + 1);
  before_.push_back(0);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    while (before_.size() <= part_at(blocks[i].time, parts))
      before_.push_back(static_cast<std::uint32_t>(i));
  before_.resize(parts + 1, static_cast<std::uint32_t>(blocks.size()));
}

namespace {

LawStretches packed(const std::vector<LawInterval>& stretches) {
  LawStretches all;
  for (const LawInterval& s : stretches) all.push_back(s);
  return all;
}

}  // namespace

TimingLaw::TimingLaw(const std::vector<LawInterval>& stretches) : TimingLaw(packed(stretches)) {}

/// It ascends with t, also with rounding: so no block before the part of t begins after t.
std::size_t TimingLaw::part_at(double t, std::size_t parts) const {
  const double last = static_cast<double>(parts - 1);
  return static_cast<std::size_t>(std::min(std::max(0.0, t) * parts_per_second_, last));
}

LawStretches::Iterator TimingLaw::find(double t) const {
  const std::size_t part = part_at(t, before_.size() - 1);
  const std::size_t first = std::max<std::size_t>(1, before_[part]);
  const std::size_t last = std::max<std::size_t>(first, before_[part + 1]);
  const auto from = stretches_.blocks_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto to = stretches_.blocks_.begin() + static_cast<std::ptrdiff_t>(last);
  const auto block = std::upper_bound(
      from, to, t, [](double x, const LawStretches::Block& b) { return x < b.time; });
  const auto number = static_cast<std::size_t>(block - stretches_.blocks_.begin()) - 1;
  return stretches_.at(t, number);
}

Motion motion_of(std::span<const LawPhase> phases, double t) {
  if (phases.empty()) return {};
  std::size_t i = 0;
  while (i + 1 < phases.size() && t >= phases[i].duration) t -= phases[i++].duration;
  return motion_of(phases[i], t);
}

Motion motion_in(const LawInterval& stretch, double t) {
  if (cruises(stretch)) {
    const double whole = stretch.length / stretch.peak;
    const double scaled_whole = whole * (stretch.length / (whole * stretch.peak));
    return {std::clamp(t, 0.0, scaled_whole) * stretch.peak, stretch.peak, 0, 0};
  }
  PhaseBuffer buffer;
  std::array<LawPhase, 7>& phase = buffer.phases;
  const auto [count, factor] = unscaled_phases(stretch, phase);
  if (count == 0) return {};
  std::size_t i = 0;
  for (double h; i + 1 < count && t >= (h = phase[i].duration * factor); ++i) t -= h;
  return motion_of(scaled(phase[i], factor), t);
}

Motion TimingLaw::at(double t) const {
  const auto here = find(t);
  const LawInterval& stretch = *here;
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
  for (const LawInterval& stretch : stretches_)
    for (const LawPhase& p : std::span(phase).first(phases(stretch, phase)))
      segments.push_back(scaled(segment_of(p), 1, stretch.start));
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

}  // namespace jounce
