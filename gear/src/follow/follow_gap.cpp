// SPDX-License-Identifier: Apache-2.0
#include "gear/src/follow/follow_gap.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"
// From ratio r0 to r1 over the master's length L, the slave must travel S. One segment with linear
// ratio is enough if
//
//   (1)  S = (r0 + r1) L / 2.
//
// Two segments, of lengths a and b = L - a, that meet at the ratio r have S = (r0 + r) a / 2 + (r +
// r1) b / 2:
//
//   (2)  r = (2 S - r0 a - r1 b) / L       for any a.
//
// The greater of both slopes is least if they are k and -k: r - r0 = k a and r - r1 = k b. With w =
// r1 - r0 and D = S - (r0 + r1) L / 2, this gives a = (L + w / k) / 2 and D = k L^2 / 4 - w^2 / (4
// k), hence
//
//   (3)  k = (2 D + sign(D) sqrt(4 D^2 + w^2 L^2)) / L^2,     |w / k| <= L.
//
// If r has the opposite sign of r0, r1 and S, the slave would run backwards. Instead, it slows down
// to rest with the slope k in a = |r0| / k, stands still, and speeds up with the slope k in b =
// |r1| / k:
//
//   (4)  k = (r0^2 + r1^2) / (2 |S|),      a + b < L, for k is above that of (3).
//
// With a and b rounded down to whole master units, the part between them continues at a ratio c:
//
//   (5)  c = (2 S - r0 a - r1 b) / (2 L - a - b).

namespace jounce::gear_detail {
namespace {

using profiles_detail::rounded_sum;

// The slave slows down to rest, or to the ratio c, and speeds up again: (4), (5).
struct Rest {
  double a;
  double b;
  double c;
};

Rest rest_of(const FollowGap& g, bool whole) {
  const double k = (g.r0 * g.r0 + g.r1 * g.r1) / (2 * std::abs(g.travel));  // (4)
  const double a = std::abs(g.r0) / k;
  const double b = std::abs(g.r1) / k;
  // From a ratio of 0 at an end, one unit of the master leads to the ratio c.
  const double p = a > 0 ? std::floor(a) : 1;
  const double q = b > 0 ? std::floor(b) : 1;
  if (!whole || p < 1 || q < 1 || p + q >= g.length) return {a, b, 0};
  return {p, q, (2 * g.travel - g.r0 * p - g.r1 * q) / (2 * g.length - p - q)};  // (5)
}

std::vector<FollowPiece> resting(const FollowGap& g, bool whole) {
  const auto [a, b, c] = rest_of(g, whole);
  const double between = g.length - a - b;
  std::vector<FollowPiece> pieces;
  if (a > 0) pieces.push_back({a, (g.r0 + c) / 2 * a});
  pieces.push_back({between, c * between, PtType::even});
  if (b > 0) pieces.push_back({b, (c + g.r1) / 2 * b});
  return pieces;
}

}  // namespace

FollowGap gap(const FollowKnot& a, const FollowKnot& b) {
  return {b.master - a.master, b.slave - a.slave, *a.ratio, *b.ratio};
}

int way(const FollowGap& g) {
  const bool forward = g.r0 >= 0 && g.r1 >= 0;
  const bool back = g.r0 <= 0 && g.r1 <= 0;
  if (forward && back) return g.travel > 0 ? 1 : (g.travel < 0 ? -1 : 0);
  return forward ? 1 : (back ? -1 : 0);
}

std::vector<FollowPiece> pieces_of(const FollowGap& g, bool whole) {
  const double D = g.travel - (g.r0 + g.r1) * g.length / 2;
  const double scale = std::abs(g.travel) + (std::abs(g.r0) + std::abs(g.r1)) * g.length;
  if (std::abs(D) <= rounded_sum * scale) return {{g.length, g.travel}};  // (1)
  const double w = g.r1 - g.r0;
  const double k =
      (2 * D + std::copysign(std::hypot(2 * D, w * g.length), D)) / (g.length * g.length);  // (3)
  double a = (g.length + w / k) / 2;
  if (whole && g.length >= 2) a = std::clamp(std::round(a), 1.0, std::ceil(g.length) - 1);
  const double b = g.length - a;
  // To rounding, a single slope covers the whole gap.
  if (!(a > 0 && b > 0)) return {{g.length, g.travel}};
  const double r = (2 * g.travel - g.r0 * a - g.r1 * b) / g.length;  // (2)
  if (way(g) * r < 0 && way(g) * g.travel > 0) return resting(g, whole);
  const double first = (g.r0 + r) / 2 * a;
  return {{a, first}, {b, g.travel - first}};
}

}  // namespace jounce::gear_detail
