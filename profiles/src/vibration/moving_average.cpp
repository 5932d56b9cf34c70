// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/moving_average.hpp"

#include <cmath>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

// The window extends from its tail x - T to its head x:
//
//   (1)  g(x)  = 1/T * integral of f from x - T to x
//   (2)  g'(x) = (f(x) - f(x - T)) / T
//
// (2) is a curve with the breaks of f(x) and of f(x - T). While head and tail lie in one segment,
// (1) becomes, with q = T as a share of the segment's length,
//
//   (3)  s^m           ->  sum over k = 1..m+1 of C(m+1, k) (-q)^(k-1) s^(m+1-k) / (m + 1)
//   (4)  A sin(w s + p) ->  A sin(w q/2) / (w q/2) * sin(w s + p - w q/2)
//
// This avoids the difference of large numbers in (2) for a short window. Otherwise, if a piece is
// no longer than T, (2) is integrated from the value that (1) gives at the start of the piece, so
// errors do not add up along the curve. Places and values count from the start of f, so a distant
// origin costs no digits.

namespace jounce {
namespace {

Segment integrated(const Segment& f, double start_value) {
  const auto g = integral(f, start_value);
  if (!g) throw InputError("degree", f.degree, "the moving average would pass degree 11");
  return *g;
}

/// In a piece as long as the window, the rounding of f (about 1e-16 of its stroke) acts like a
/// change of the velocity over T: the error of the acceleration is 1e-16 * stroke / T^2.
constexpr double shortest_window = 1e-5;
constexpr double longest_window = 1e4;

void require_window(double window, double length) {
  require_positive("window", window);
  if (window < shortest_window * length)
    throw InputError("window", window,
                     "must be at least " + six_digits_up(shortest_window * length) +
                         ", 1e-5 of the curve's length: rounding dominates a shorter one");
  if (window > longest_window * length)
    throw InputError("window", window,
                     "must be at most " + six_digits_down(longest_window * length) +
                         ", 10000 times the curve's length");
}

/// The average (1) at the right end of the window f.
template <class Over>
double mean(const Curve<Over>& f) {
  double total = 0;
  double length = 0;  // a difference of start and end would have fewer digits
  for (const Segment& piece : f.segments()) {
    total += value(integrated(piece, 0), 1);
    length += piece.length;
  }
  return total / length;
}

/// (3) and (4).
Segment averaged(const Segment& f, double q) {
  Segment g = f;
  g.c.fill(0);
  for (std::size_t m = 0; m <= static_cast<std::size_t>(f.degree); ++m) {
    double factor = f.c[m];  // times C(m + 1, k) (-q)^(k-1) / (m + 1)
    for (std::size_t k = 1; k <= m + 1; ++k) {
      g.c[m + 1 - k] += factor;
      factor *= -q * static_cast<double>(m + 1 - k) / static_cast<double>(k + 1);
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const double half = f.sine[i].angle * q / 2;
    if (half != 0) g.sine[i].amplitude *= std::sin(half) / half;
    g.sine[i].phase -= half;
  }
  return g;
}

/// The average g over one piece of (2), which begins at x.
template <class Over>
Segment piece(const Curve<Over>& f, double window, double x, const Segment& slope) {
  const auto swept = between(f, x - window, x + slope.length);
  const double q = window / (window + slope.length);
  if (swept.segments().size() > 1) return integrated(slope, mean(between(f, x - window, x)));
  Segment g = part(averaged(swept.segments().front(), q), q, 1);
  g.length = slope.length;
  return g;
}

}  // namespace

template <class Over>
Curve<Over> moving_average(const Curve<Over>& f, double window) {
  require_window(window, f.length());
  require_resting_ends(f);
  const double origin = value(f.segments().front(), 0);
  const auto from_origin = with(shifted(f, -f.start(), -origin),
                                repeats(f.outside()) ? f.outside() : Extrapolation::hold);
  const auto head = delayed(from_origin, 0, window);
  const auto tail = delayed(from_origin, window, window);
  const auto slope = sum(scaled(head, 1 / window), scaled(tail, -1 / window));  // (2)

  std::vector<Segment> pieces;
  pieces.reserve(slope.segments().size());
  for (std::size_t i = 0; i < slope.segments().size(); ++i) {
    const Segment g = piece(from_origin, window, slope.breaks()[i], slope.segments()[i]);
    pieces.push_back(scaled(g, 1, origin));
  }
  return Curve<Over>(std::move(pieces), f.start(), from_origin.outside());
}

template Trajectory moving_average(const Trajectory&, double);
template Cam moving_average(const Cam&, double);

}  // namespace jounce
