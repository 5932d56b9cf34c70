// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/splice.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_value;

using Segments = std::vector<Segment>;

void require_not_before(const Trajectory& f, double t) {
  require_finite("t", t);
  if (t < f.start())
    throw InputError("t", t, "must not be before the motion begins, at " + number(f.start()));
}

/// True if two times on f differ by no more than the rounding of the breaks.
bool same_time(const Trajectory& f, double a, double b) {
  return std::abs(a - b) <= rounded_value * std::max(std::abs(f.start()), std::abs(f.end()));
}

/// The state of f after its end. A velocity within rounding is zero.
MotionState beyond(const Trajectory& f, double t) {
  const Segment& last = f.segments().back();
  const Jet end = evaluate(last, 1);
  const bool rests = std::abs(end[1]) <= rounded_value * magnitude(derivative(last));
  const double v = rests ? 0 : end[1];
  return {end[0] + v * (t - f.end()), v, 0};
}

/// True if f has zero acceleration at one end of the interval around t in which its acceleration is
/// continuous and not zero.
bool is_built_up(const Trajectory& f, double t) {
  const auto segments = f.segments();
  const auto begin = [&](std::size_t i) { return evaluate(segments[i], 0)[2]; };
  const auto end = [&](std::size_t i) { return evaluate(segments[i], 1)[2]; };
  double greatest = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
    greatest = std::max({greatest, std::abs(begin(i)), std::abs(end(i))});
  const double rounding = rounded_input * greatest;
  const auto none = [&](double a) { return std::abs(a) <= rounding; };
  const auto joined = [&](std::size_t i) {  // true if segment i continues the previous one
    return !none(begin(i)) && none(begin(i) - end(i - 1));
  };
  const auto after = std::upper_bound(f.breaks().begin() + 1, f.breaks().end() - 1, t);
  auto first = static_cast<std::size_t>(after - f.breaks().begin()) - 1;
  auto last = first;
  while (first > 0 && joined(first)) --first;
  while (last + 1 < segments.size() && joined(last + 1)) ++last;
  return none(begin(first)) || none(end(last));
}

/// The segments of f from its start to t, which is inside f or at its end.
Segments cut(const Trajectory& f, double t) {
  Segments kept;
  for (std::size_t i = 0; i < f.segments().size() && f.breaks()[i] < t; ++i) {
    const Segment& piece = f.segments()[i];
    if (same_time(f, f.breaks()[i], t)) break;
    const bool whole = f.breaks()[i + 1] <= t || same_time(f, f.breaks()[i + 1], t);
    kept.push_back(whole ? piece : part(piece, 0, (t - f.breaks()[i]) / piece.length));
  }
  return kept;
}

void append(Segments& segments, const Trajectory& next) {
  segments.insert(segments.end(), next.segments().begin(), next.segments().end());
}

/// Sets the policy of a motion that was cut and continued: hold, or refuse.
Trajectory with_end(const Trajectory& f) {
  const bool rests = beyond(f, f.end()).velocity == 0;
  return with(f, rests ? Extrapolation::hold : Extrapolation::refuse);
}

/// f, extended at rest to the time `from` before its start.
Trajectory from_standstill(const Trajectory& f, double from) {
  const double lead = f.start() - from;
  if (!(lead > 0)) return f;
  const double p = f.at(f.start()).position;
  Segments segments{line(lead, p, p)};
  append(segments, f);
  return Trajectory(std::move(segments), from, f.outside());
}

}  // namespace

MotionState state_at(const Trajectory& f, double t) {
  require_not_before(f, t);
  if (t < f.end() && !same_time(f, t, f.end())) {
    const Motion now = f.at(t);
    return state_of(now);
  }
  return beyond(f, std::max(t, f.end()));
}

MotionState state_for(const Trajectory& f, double t, double jerk) {
  MotionState now = state_at(f, t);
  if (now.acceleration != 0 && (jerk == 0 || !is_built_up(f, t))) now.acceleration = 0;
  return now;
}

Trajectory until(const Trajectory& f, double t) {
  require_not_before(f, t);
  Segments segments = cut(f, std::min(t, f.end()));
  if (segments.empty()) throw InputError("t", t, "must be after the motion begins");
  if (t > f.end() && !same_time(f, t, f.end())) {
    const double length = t - f.end();
    segments.push_back(line(length, beyond(f, f.end()).position, beyond(f, t).position));
  }
  return Trajectory(std::move(segments), f.start(), f.outside());
}

Trajectory spliced(const Trajectory& running, double t, const Trajectory& next) {
  require_not_before(running, t);
  if (same_time(running, t, running.start())) return with_end(shifted(next, t - next.start()));
  return with_end(concatenated(until(running, t), next));
}

Trajectory spliced(const Trajectory& running, double t, std::span<const Profile> next) {
  require_not_before(running, t);
  std::optional<Trajectory> result;
  if (!same_time(running, t, running.start())) result = until(running, t);
  for (const Profile& profile : next) {
    if (profile.phases() == 0) continue;
    const Trajectory curve = profile.curve();
    result = result ? concatenated(*result, curve) : shifted(curve, t);
  }
  if (!result)
    throw InputError("t", t,
                     "leaves no motion: nothing moves before this time, nor after the change");
  return with_end(*result);
}

Trajectory superimposed(const Trajectory& f, const Trajectory& g) {
  const double start = std::min(f.start(), g.start());
  const double end = std::max(f.end(), g.end());
  return sum(until(from_standstill(f, start), end), until(from_standstill(g, start), end));
}

}  // namespace jounce
