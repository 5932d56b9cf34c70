// SPDX-License-Identifier: Apache-2.0
#include "path/src/corners/turn.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"

#include "path/src/cube_root.hpp"

// By (4), the velocity of a turn is the lesser of two bounds. The one of the acceleration falls
// with b, the one of the jerk rises, both for (3) fixed and for a fixed length. The fastest turn
// has equal bounds, or b = 1/2. With a and j divided by |D_i|:
//
//   (6)  a^3 (1 - b) = j^2 b^2 l
//   (7)  l = c / i(b):   (4 - k) b^2 - 6 b + 3 = 0,     k = 24 j^2 c / a^3
//   (8)  l fixed:        m b^2 + b - 1 = 0,             m = j^2 l / a^3
//   (9)  v fixed:        b = a^2 / (a^2 + v j)          the least e: (3) over either bound of (4)
//   (10) curvature k fixed, l = |D| / ((1 - b) k C^2):  (1 - b) / b = j sqrt(|D| / (k C^2 a^3))

namespace jounce {

Jet turn_rise(double share, double x) {
  const double b = share;
  const double g = 1 / (1 - b);
  if (x < b) return {x * x * x * g / (6 * b), x * x * g / (2 * b), x * g / b, g / b};
  if (x <= 1 - b) {
    const double y = x - b / 2;
    return {g * (y * y / 2 + b * b / 24), g * y, g, 0};
  }
  const double z = 1 - x;
  return {0.5 - z + z * z * z * g / (6 * b), 1 - z * z * g / (2 * b), z * g / b, -g / b};
}

void turn_segments(double start, double before, double after, double length, double share,
                   std::vector<Segment>& out) {
  const double bend = after - before;
  const double g = 1 / (1 - share);
  const double parts[] = {share, 1 - 2 * share, share};
  const double from[] = {0, share, 1 - share};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(parts[k] > 0)) continue;
    const Jet rise = turn_rise(share, k == 2 ? 1 - share : from[k]);
    const double h = parts[k];  // in x
    const double slope = k == 0 ? g / share : k == 2 ? -g / share : 0;
    Segment f;
    f.length = h * length;
    f.degree = slope != 0 ? 3 : 2;
    f.c[0] = start + length * (before * from[k] + bend * rise[0]);
    f.c[1] = length * h * (before + bend * (k == 0 ? 0 : rise[1]));
    f.c[2] = length * h * h / 2 * bend * (k == 0 ? 0 : g);
    f.c[3] = length * h * h * h / 6 * bend * slope;
    out.push_back(f);
  }
}

double turn_velocity(const TurnRates& rates, double share, double length) {
  const double by_acceleration = std::sqrt(rates.acceleration * (1 - share) * length);
  if (rates.jerk == TurnRates::none) return by_acceleration;
  return std::min(by_acceleration,
                  path_detail::cube_root(rates.jerk * share * (1 - share) * length * length));
}

Turn fastest_turn(const TurnRates& rates, double offset, double length) {
  const auto with = [&](double share) {
    const double l = std::min(offset / turn_offset(share), length);
    return Turn{share, l, turn_velocity(rates, share, l)};
  };
  if (rates.jerk == TurnRates::none) return with(0);
  if (rates.acceleration == TurnRates::none) return with(0.5);
  const double scale = rates.jerk * rates.jerk / profiles_detail::cube(rates.acceleration);
  const double k = 24 * scale * offset;
  const double by_offset = k > 4 ? 3 / (3 + std::sqrt(3 * k - 3)) : 0.5;  // (7)
  const Turn turn = with(by_offset);
  if (turn.length < length) return turn;
  const double m = scale * length;
  const double by_length = m > 2 ? 2 / (1 + std::sqrt(1 + 4 * m)) : 0.5;  // (8)
  if (turn_offset(by_length) * length <= offset) return with(by_length);
  // Both limits apply: i(b) l = offset, with b between the two. i falls from 1/8 to 1/12.
  const double i = offset / length;
  const double half = 3 - 12 * i;  // 4 b^2 - (6 - 24 i) b + 3 - 24 i = 0
  const double share = (half - profiles_detail::root(half * half - 4 * (3 - 24 * i))) / 4;
  return with(std::clamp(share, 0.0, 0.5));
}

Turn least_turn(const TurnRates& rates, double velocity) {
  const double a2 = profiles_detail::square(rates.acceleration);
  double share = 0;
  if (rates.acceleration == TurnRates::none)
    share = rates.jerk == TurnRates::none ? 0 : 0.5;
  else if (rates.jerk != TurnRates::none)
    share = std::min(0.5, a2 / (a2 + velocity * rates.jerk));  // (9)
  double length = velocity * velocity / (rates.acceleration * (1 - share));
  if (share > 0)
    length = std::max(
        length, std::sqrt(profiles_detail::cube(velocity) / (rates.jerk * share * (1 - share))));
  return {share, length, velocity};
}

Turn curved_turn(const TurnRates& rates, double bend, double curvature) {
  double share = 0;
  if (rates.jerk != TurnRates::none) {
    const double ratio =
        rates.jerk * std::sqrt(bend / (curvature * profiles_detail::cube(rates.acceleration)));
    share = std::min(0.5, 1 / (1 + ratio));  // (10)
  }
  const double length = bend / ((1 - share) * curvature);
  return {share, length, turn_velocity(rates, share, length)};
}

}  // namespace jounce
