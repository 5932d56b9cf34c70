// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/detail/ramps.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace jounce::profiles_detail {
namespace {

using std::numbers::pi;

/// A phase of a law for a change that may be zero.
template <class Law>
auto ramp_of(const Law& law, double dv) {
  return dv > 0 ? law.ramp(dv) : decltype(law.ramp(dv)){};
}

/// sin^2 from v0 to v1 (of either order), starting at p: the integral of
/// v0 + (v1 - v0) sin^2(pi s / 2) over s, times the length.
Segment sine_edge(double length, double p, double v0, double v1) {
  Segment f;
  f.length = length;
  f.degree = 1;
  f.c[0] = p;
  f.c[1] = (v0 + v1) / 2 * length;
  f.sines = 1;
  f.sine[0] = {(v0 - v1) * length / (2 * pi), pi, 0};
  return f;
}

/// The jerks of a ramp. They cancel to the last bit, because a remaining acceleration would act
/// through the whole cruise.
struct Jerks {
  double rising, falling;
  double fall;  ///< s, of this ramp, to the last bits
};

Jerks jerks(const RampShape& r) {
  if (!(r.rise > 0)) return {0, 0, 0};
  const double rising = (r.peak - r.begin) / r.rise;
  if (r.begin == 0) return {rising, -rising, r.fall};
  const double reached = r.begin + rising * r.rise;
  double fall = r.fall;
  while (reached / fall * fall != reached) fall = std::nextafter(fall, 2 * fall);
  return {rising, -reached / fall, fall};
}

void add_steps(Profile& result, const RampShape& up, double cruise, const RampShape& down,
               double sign) {
  result.add(up.hold, sign * up.peak);
  result.add(cruise, 0);
  result.add(down.hold, -sign * down.peak);
}

void add_jerks(Profile& result, const RampShape& up, double cruise, const RampShape& down,
               double sign) {
  const Jerks first = jerks(up);
  const Jerks last = jerks(down);
  result.add(up.rise, sign * first.rising);
  result.add(up.hold, 0);
  result.add(first.fall, sign * first.falling);
  result.add(cruise, 0);
  result.add(last.fall, sign * last.falling);
  result.add(down.hold, 0);
  result.add(down.rise, sign * last.rising);
}

}  // namespace

template <class Law>
Profile profile(const RampedMove<Law>& move, double from, double to) {
  const double sign = to > from ? 1 : -1;
  const RampShape up = ramp_of(move.up, move.dv0);
  const RampShape down = ramp_of(move.down, move.dv1);
  const bool steps = up.rise + down.rise == 0;
  Profile result({from, sign * move.v0, sign * up.begin}, steps ? 2 : 3);
  (steps ? add_steps : add_jerks)(result, up, move.cruise, down, sign);
  result.finish({to, sign * move.v1, -sign * down.begin});
  return result;
}

template Profile profile(const RampedMove<JerkLaw>&, double, double);
template Profile profile(const RampedMove<ShareLaw>&, double, double);

Trajectory curve(const RampedMove<SineLaw>& move, double from, double to) {
  const double sign = to > from ? 1 : -1;
  const double v0 = sign * move.v0;
  const double v1 = sign * move.v1;
  const double peak = sign * (move.v0 + move.dv0);
  const double up = ramp_of(move.up, move.dv0).duration();
  const double down = ramp_of(move.down, move.dv1).duration();
  // Built from both ends, so the rounding error is where they meet.
  const double begin = from + (v0 + peak) / 2 * up;
  const double end = to - (peak + v1) / 2 * down;
  std::vector<Segment> segments;
  if (up > 0) segments.push_back(sine_edge(up, from, v0, peak));
  if (move.cruise > 0) segments.push_back(line(move.cruise, begin, begin + peak * move.cruise));
  if (down > 0) segments.push_back(sine_edge(down, end, peak, v1));
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

}  // namespace jounce::profiles_detail
