// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/shaper.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

// In half a damped period T/2 the mode turns by 180 degrees and decays by
//
//   (1)  K = e^(-pi D / sqrt(1 - D^2))
//
// Impulses a_i K^i at the times i T/2 leave, at the instant n T/2 of the last one (vibration.cpp,
// (1)),
//
//   (2)  V = K^n |a_0 - a_1 + a_2 - ...| / sum of a_i K^i
//
// at the mode. zv: a = 1, 1 and zvd: a = 1, 2, 1 make it 0. For ei take a = 1, q, 1:
//
//   (3)  V = K^2 (2 - q) / (1 + q K + K^2)   gives   q = (2 K^2 - V (1 + K^2)) / (K (K + V))
//
// Undamped, K = 1, these are the 1 + V, 2 - 2 V, 1 + V (over 4) of Singhose, Seering & Singer.

namespace jounce {
namespace {

using profiles_detail::rounded_sum;
using profiles_detail::rounded_value;

constexpr double longest_shaper =
    1e4;  // longest shaper, in lengths of the motion; above, no digits are left
using std::numbers::pi;

std::vector<double> weights(const ShaperSpec& spec, double K) {
  if (spec.kind == ShaperKind::zv) return {1, 1};
  if (spec.kind == ShaperKind::zvd) return {1, 2, 1};
  const double V = spec.tolerance;
  if (!(V > 0 && V < 1)) throw InputError("tolerance", V, "must be greater than 0 and less than 1");
  const double q = (2 * K * K - V * (1 + K * K)) / (K * (K + V));  // (3)
  if (!(q > 0))
    throw InputError("tolerance", V, "is met without a shaper, by the damping of the mode");
  return {1, q, 1};
}

/// Requires that the copies begin at 0 and that their amplitudes have the sum 1.
void require_shaper(std::span<const Impulse> impulses) {
  require_valid(impulses);
  double total = 0;
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    if (i == 0 ? impulses[i].time != 0 : impulses[i].time <= impulses[i - 1].time)
      throw InputError("impulse[" + std::to_string(i + 1) + "].time", impulses[i].time,
                       "times must ascend from 0");
    total += impulses[i].amplitude;
  }
  if (std::abs(total - 1) > rounded_sum)
    throw InputError("impulses", total, "is the sum of the amplitudes, which must be 1");
}

}  // namespace

std::vector<Impulse> shaper(const ShaperSpec& spec) {
  require_valid(spec.mode);
  const double D = spec.mode.damping;
  const double root = std::sqrt((1 - D) * (1 + D));
  const double half_period = 1 / (2 * spec.mode.frequency * root);
  const double K = std::exp(-pi * D / root);  // (1)
  std::vector<Impulse> impulses;
  double decay = 1;
  double total = 0;
  for (const double weight : weights(spec, K)) {
    impulses.push_back({static_cast<double>(impulses.size()) * half_period, weight * decay});
    total += weight * decay;
    decay *= K;
  }
  for (Impulse& impulse : impulses) impulse.amplitude /= total;
  return impulses;
}

std::vector<Impulse> convolved(std::span<const Impulse> a, std::span<const Impulse> b) {
  require_valid(a);
  require_valid(b);
  std::vector<Impulse> all;
  for (const Impulse& x : a)
    for (const Impulse& y : b) all.push_back({x.time + y.time, x.amplitude * y.amplitude});
  std::sort(all.begin(), all.end(),
            [](const Impulse& x, const Impulse& y) { return x.time < y.time; });
  std::vector<Impulse> merged;  // impulses at the same time (to rounding) become one
  for (const Impulse& x : all)
    if (!merged.empty() && x.time - merged.back().time <= rounded_value * all.back().time)
      merged.back().amplitude += x.amplitude;
    else
      merged.push_back(x);
  return merged;
}

Trajectory shaped(const Trajectory& f, std::span<const Impulse> impulses) {
  require_shaper(impulses);
  require_resting_ends(f);
  const double last = impulses.back().time;
  if (last > longest_shaper * f.length())
    throw InputError("impulse[" + std::to_string(impulses.size()) + "].time", last,
                     "must be at most " + six_digits_down(longest_shaper * f.length()) +
                         ", 10000 times the motion's length");
  // subtracted, so that a distant origin costs no digits
  const double origin = value(f.segments().front(), 0);
  const Trajectory from_origin = shifted(f, -f.start(), -origin);
  Trajectory total = scaled(delayed(from_origin, 0, last), impulses.front().amplitude);
  for (const Impulse& impulse : impulses.subspan(1))
    total = sum(total, scaled(delayed(from_origin, impulse.time, last), impulse.amplitude));
  return shifted(total, f.start(), origin);
}

}  // namespace jounce
