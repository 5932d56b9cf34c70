// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/cam/algebra/inverse.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

// Reversion of a series. Let d be the master's travel and w = a1 d + a2 d^2 + ... the slave's. Then
// d is found from
//
//   (1)  d = (w - sum over k >= 2 of a_k d^k) / a1,
//
// Each pass gains one order. If |a_k| <= A_k for k >= 2 and |a1| >= m over a whole piece, the
// series of
//
//   (2)  D = (w + sum over k >= 2 of A_k D^k) / m
//
// has only positive coefficients, which bound those of d at every point of the piece.

namespace jounce {
namespace {

/// Equation (1); with sign = -1, for majorants, equation (2). Ignores a[0] and a[1] of `higher`.
template <std::size_t n>
profiles_detail::Series<n> reverted(profiles_detail::Series<n> higher, double a1, double sign = 1) {
  higher[0] = higher[1] = 0;
  profiles_detail::Series<n> d{};
  for (std::size_t pass = 1; pass < n; ++pass) {
    const auto rest = profiles_detail::substituted(higher, d);
    for (std::size_t k = 1; k < n; ++k) d[k] = ((k == 1 ? 1 : 0) - sign * rest[k]) / a1;
  }
  return d;
}

/// An interval of the slave between two breaks of the inverse, and its place in a segment of the
/// cam.
struct Stroke {
  const Inverse* inverse;
  std::size_t segment;
  double from, to;  ///< slave positions
  double s0, s1;    ///< the same ends, as positions in the segment

  [[nodiscard]] const Segment& f() const { return inverse->cam().segments()[segment]; }
  [[nodiscard]] double s_at(double slave, Side side) const {
    const double x = inverse->at(slave, side).position - inverse->cam().breaks()[segment];
    return std::clamp(x / f().length, 0.0, 1.0);
  }

  [[nodiscard]] double length() const { return to - from; }
  [[nodiscard]] profiles_detail::EndSeries end(int which) const {
    const double s = which == 0 ? s0 : s1;
    const profiles_detail::EndSeries a = profiles_detail::taylor(f(), s);
    profiles_detail::EndSeries d = reverted(a, a[1]);
    double unit = f().length;
    for (double& c : d) {
      c *= unit;
      unit *= length();
    }
    d[0] = inverse->cam().breaks()[segment] + s * f().length;
    return d;
  }
  [[nodiscard]] double twelfth() const {
    const Segment piece = part(f(), std::min(s0, s1), std::max(s0, s1));
    const Range slope = extrema(Cam({piece}), 1);
    const double least = std::min(std::abs(slope.min.value), std::abs(slope.max.value));
    const auto d = reverted(profiles_detail::majorant(piece, 1), least * piece.length, -1);
    return d.back() * std::pow(length(), 12) * piece.length;
  }
  [[nodiscard]] std::pair<Stroke, Stroke> halves() const {
    Stroke left = *this;
    Stroke right = *this;
    left.to = right.from = from + (to - from) / 2;
    left.s1 = right.s0 = s_at(left.to, Side::right);
    return {left, right};
  }
};

Stroke stroke(const Inverse& g, double from, double to) {
  const auto breaks = g.cam().breaks();
  const double middle = g.at(from + (to - from) / 2).position;
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, middle);
  Stroke piece{&g, static_cast<std::size_t>(after - breaks.begin()) - 1, from, to, 0, 0};
  piece.s0 = piece.s_at(from, Side::right);
  piece.s1 = piece.s_at(to, Side::left);
  return piece;
}

void require_motion(const Inverse& g, double slave, Side side) {
  if (!std::isfinite(g.at(slave, side).geo_velocity))
    throw InputError(
        "slave", slave,
        "is where the slave is at rest: the slope of the inverse is infinite there, and "
        "no table can follow it. Begin or end a little inside, with from and to");
}

}  // namespace

Fitted<OverMaster> inverse_within(const Inverse& g, double from, double to, double tolerance) {
  if (!(from < to)) throw InputError("to", to, "must be greater than from = " + number(from));
  if (from < g.start())
    throw InputError(
        "from", number(from),
        "must be at least " + six_digits_up(g.start()) + ", where the rise or fall begins");
  if (to > g.end())
    throw InputError(
        "to", number(to),
        "must be at most " + six_digits_down(g.end()) + ", where the rise or fall ends");
  profiles_detail::require_tolerance(tolerance,
                                     std::max(std::abs(g.master_from()), std::abs(g.master_to())));
  std::vector<double> ends{from};
  for (const double y : g.breaks())
    if (y > from && y < to) ends.push_back(y);
  ends.push_back(to);
  std::vector<Segment> segments;
  Jet error{};
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    require_motion(g, ends[i], Side::right);
    require_motion(g, ends[i + 1], Side::left);
    profiles_detail::fit(stroke(g, ends[i], ends[i + 1]), tolerance, segments, error);
  }
  return {Cam(std::move(segments), from), error};
}

}  // namespace jounce
