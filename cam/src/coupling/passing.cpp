// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/passing.hpp"

#include <cmath>

namespace jounce {
namespace {

/// The cubic by positions and velocities at both ends, 0 <= s <= 1.
double cubic(const Sample& a, const Sample& b, double s) {
  const double h = b.t - a.t;
  const double r = 1 - s;
  return r * r * ((1 + 2 * s) * a.master[0] + s * h * a.master[1]) +
         s * s * ((1 + 2 * r) * b.master[0] - r * h * b.master[1]);
}

double cubic_slope(const Sample& a, const Sample& b, double s) {
  const double h = b.t - a.t;
  const double r = 1 - s;
  return 6 * s * r * (b.master[0] - a.master[0]) / h + r * (1 - 3 * s) * a.master[1] +
         s * (3 * s - 2) * b.master[1];
}

}  // namespace

Sample between(const Sample& before, const Sample& now, double t) {
  const double s = (t - before.t) / (now.t - before.t);
  if (!(s < 1)) return now;
  const auto mixed = [&](std::size_t k) {
    return before.master[k] + s * (now.master[k] - before.master[k]);
  };
  return {t, {cubic(before, now, s), cubic_slope(before, now, s), mixed(2), mixed(3)}};
}

std::optional<Sample> passing(const Sample& before, const Sample& now, double level) {
  const double from = before.master[0] - level;
  const double to = now.master[0] - level;
  if (to == 0 || !(now.t > before.t)) return to == 0 ? std::optional(now) : std::nullopt;
  if (from == 0 || (from < 0) == (to < 0)) return std::nullopt;
  double a = 0;
  double b = 1;
  for (double s = 0.5; s > a && s < b; s = a + (b - a) / 2)
    ((cubic(before, now, s) < level) == (from < 0) ? a : b) = s;
  Sample at = between(before, now, before.t + b * (now.t - before.t));
  at.master[0] = level;
  return at;
}

}  // namespace jounce
