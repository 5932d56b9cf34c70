// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/notch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/error.hpp"

// Because H - 1 = -2 (D - D0) w s / (s^2 + 2 D w s + w^2), the filtered motion is
//
//   (1)  y = f - 2 (D - D0) Q,    Q'' + 2 D w Q' + w^2 Q = w f'
//
// with Q at rest before the motion. Over a step of length h, let r in [0, 1], b = w h, f = sum of
// f_k r^k and Q = sum of c_k r^k. Comparing powers in (1) gives all c_k from the first two:
//
//   (2)  c_(k+2) = b ((k + 1) f_(k+1) - 2 D (k + 1) c_(k+1) - b c_k) / ((k + 1) (k + 2))
//
// Q is represented by c_0 to c_10. The other terms, and their derivative with respect to r, are at
// most
//
//   (3)  e = sum of |c_k|,  e' = sum of k |c_k|   over k >= 11
//
// The error of one step in Q and Q' is a free motion of (1) in the following steps, in which Q^2 +
// (Q'/w)^2 does not grow. So errors only add up, and each step adds at most
//
//   (4)  sqrt( e^2 + (e'/b)^2 )
//
// For the same reason, sqrt(Q^2 + (Q'/w)^2) bounds the whole tail that is cut off.

namespace jounce {
namespace {

using profiles_detail::two_pi;
constexpr double widest_step = 0.125;  // rad of the filter and of any sine in f
// Coefficients up to degree 10, so that the result can still be integrated.
constexpr std::size_t kept = 11;
constexpr std::size_t terms = 32;  // the next terms are negligible: (1/8)^32 / 32!
using Series = std::array<double, terms>;

/// The Taylor coefficients f_k of a piece.
Series series(const Segment& f) {
  Series a{};
  std::copy(f.c.begin(), f.c.end(), a.begin());
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const auto& [amplitude, angle, phase] = f.sine[i];
    const std::array cycle{std::sin(phase), std::cos(phase), -std::sin(phase), -std::cos(phase)};
    double factor = amplitude;
    for (std::size_t k = 0; k < terms; ++k) {
      a[k] += factor * cycle[k % 4];
      factor *= angle / static_cast<double>(k + 1);
    }
  }
  return a;
}

class Filter {
 public:
  explicit Filter(const NotchSpec& spec)
      : w_(two_pi * spec.frequency),
        damping_(spec.damping),
        gain_(2 * (spec.damping - spec.mode_damping)) {}

  [[nodiscard]] double steps(const Segment& f) const {
    double widest = w_ * f.length;
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i)
      widest = std::max(widest, std::abs(f.sine[i].angle));
    return std::max(1.0, std::ceil(widest / widest_step));
  }

  /// A step of the position: an impulse in (1).
  void jump(double height) { rate_ += height; }

  /// Appends the response to one segment.
  void run(const Segment& f) {
    const double n = steps(f);
    for (double i = 0; i < n; ++i) step(n == 1 ? f : part(f, i / n, (i + 1) / n));
  }

  /// Bound of the response at all later times, if the command is at rest from now on.
  [[nodiscard]] double tail() const { return gain_ * std::hypot(q_, rate_); }
  [[nodiscard]] double error() const { return gain_ * error_; }
  [[nodiscard]] double longest() const { return widest_step / w_; }

  std::vector<Segment> pieces;

 private:
  void step(const Segment& f) {
    const double b = w_ * f.length;
    const Series a = series(f);
    Series c{q_, b * rate_};
    for (std::size_t k = 0; k + 2 < terms; ++k) {  // (2)
      const auto m = static_cast<double>(k + 1);
      c[k + 2] = b * (m * a[k + 1] - 2 * damping_ * m * c[k + 1] - b * c[k]) / (m * (m + 1));
    }
    Segment y = f;
    y.degree = std::max(f.degree, static_cast<int>(kept) - 1);
    for (std::size_t k = 0; k < kept; ++k) y.c[k] -= gain_ * c[k];
    pieces.push_back(y);
    advance(c, b);
  }

  void advance(const Series& c, double b) {
    q_ = rate_ = 0;
    double e = 0;
    double slope = 0;
    for (std::size_t k = kept; k-- > 0;) {
      q_ += c[k];
      rate_ += static_cast<double>(k) * c[k] / b;
    }
    for (std::size_t k = kept; k < terms; ++k) {  // (3)
      e += std::abs(c[k]);
      slope += static_cast<double>(k) * std::abs(c[k]);
    }
    error_ += std::hypot(e, slope / b);  // (4)
  }

  double w_, damping_, gain_;
  double q_ = 0;
  double rate_ = 0;  // Q' / w
  double error_ = 0;
};

void require_valid(const NotchSpec& spec) {
  require_positive("frequency", spec.frequency);
  require_finite("damping", spec.damping);
  if (spec.damping < 0.05) throw InputError("damping", spec.damping, "must be at least 0.05");
  require_not_negative("mode_damping", spec.mode_damping);
  if (spec.mode_damping >= spec.damping)
    throw InputError("mode_damping", spec.mode_damping, "must be less than damping");
  if (!(spec.settled > 0 && spec.settled < 1))
    throw InputError("settled", spec.settled, "must be greater than 0 and less than 1");
}

double travel_of(const Trajectory& f, const Filter& filter) {
  if (repeats(f.outside()))
    throw InputError("motion", "wraps", "a notch needs a motion with an end");
  double steps = 0;
  for (const Segment& piece : f.segments()) steps += filter.steps(piece);
  if (steps > 1e6)
    throw InputError(
        "frequency", "",
        "is so high for this length of the motion that the filter needs more than a million "
        "steps: lower it, or shorten the motion");
  const Range range = extrema(f, 0);
  if (!(range.max.value > range.min.value)) throw InputError("motion", "", "does not move");
  return range.max.value - range.min.value;
}

}  // namespace

Notched notched(const Trajectory& f, const NotchSpec& spec) {
  require_valid(spec);
  Filter filter(spec);
  const double travel = travel_of(f, filter);
  double before = value(f.segments().front(), 0);
  for (const Segment& piece : f.segments()) {
    filter.jump(value(piece, 0) - before);
    filter.run(piece);
    before = value(piece, 1);
  }
  while (filter.tail() > spec.settled * travel) filter.run(line(filter.longest(), before, before));

  const Jet now = evaluate(filter.pieces.back(), 1);
  const Segment close = quintic(32 * filter.longest(), now[0], now[1], now[2], before, 0, 0);
  const Range swing = extrema(Trajectory({scaled(close, 1, -before)}), 0);
  const double cut = std::abs(swing.peak().value) + filter.tail();
  filter.pieces.push_back(close);
  return {Trajectory(std::move(filter.pieces), f.start(), Extrapolation::hold),
          filter.error() + cut};
}

}  // namespace jounce
