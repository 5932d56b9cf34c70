// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/break_index.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// An immutable piecewise function of one variable. Every generator returns one; checks, samplers,
/// validators and streams take one.
///
///     Trajectory move = trapezoid({.to = 50, .velocity = 10, .acceleration = 20}).curve();
///     Motion now = move.at(0.25);               // position, velocity, acceleration, jerk
///     Range v = extrema(move, 1);               // exact: extreme velocities and their times
///     Trajectory back = reversed(move);
///     Trajectory both = concatenated(move, back);
///     Report report = check(both, {.velocity = 10});
///
/// **Vocabulary.** The curve runs over time (a Trajectory) or over the master's position (a Cam):
/// its *variable*. A *segment* is one formula. The *breaks* are the start, the points where
/// segments meet, and the end, so there is one more break than segments. Segments store lengths;
/// breaks are start plus their running sum.
///
/// **Intervals.** Segments are half-open, the last one closed: at a break the curve has the value
/// of the segment that begins there (right-continuous). Side::left selects the limit from the left.
///
/// **Outside [start, end]** the policy given at construction applies; see Extrapolation in jet.hpp.
///
/// **Throws** InputError if there is no segment, if a length is not finite and positive, if a
/// coefficient is not finite, or if start is not finite or so large that rounding removes a whole
/// length. Other members throw nothing. Evaluation never allocates.
template <class Over>
class Curve {
 public:
  using Point = typename Over::Point;  ///< Motion for a Trajectory, Transfer for a Cam

  /// `start`: the first break, in the unit of the variable.
  explicit Curve(std::vector<Segment> segments, double start = 0,
                 Extrapolation outside = Extrapolation::refuse);

  [[nodiscard]] double start() const { return breaks_.front(); }
  [[nodiscard]] double end() const { return breaks_.back(); }
  [[nodiscard]] double length() const { return end() - start(); }
  [[nodiscard]] Extrapolation outside() const { return outside_; }
  /// Change of the value over one period if outside() is Extrapolation::advance; otherwise 0.
  [[nodiscard]] double advance() const;
  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }

  /// Returns the value and three derivatives at x, as an array.
  [[nodiscard]] Jet jet(double x, Side side = Side::right) const;
  /// Returns the value and three derivatives at x, as named members.
  [[nodiscard]] Point at(double x, Side side = Side::right) const {
    return point<Over>(jet(x, side));
  }

  /// Writes at(x[i]) to out[i] for all i; fastest if x ascends. Both spans have the same size.
  void sample(std::span<const double> x, std::span<Point> out) const;

 private:
  [[nodiscard]] Jet at_end_or_outside(double x, Side side) const;

  std::vector<Segment> segments_;
  std::vector<double> breaks_;
  BreakIndex index_;
  Extrapolation outside_;
};

using Trajectory = Curve<OverTime>;
using Cam = Curve<OverMaster>;

// ---- algebra: each returns a new curve over the same axis -------------------------------------

/// Returns the first derivative, as a curve over the same variable.
template <class Over>
Curve<Over> derivative(const Curve<Over>& f);

/// Returns the integral of f: start_value at start(), continuous at every break. Throws InputError
/// if a segment already has degree 11.
template <class Over>
Curve<Over> integral(const Curve<Over>& f, double start_value = 0);

/// f moved by dx in its variable and by dy in value.
template <class Over>
Curve<Over> shifted(const Curve<Over>& f, double dx, double dy = 0);

/// f with its value multiplied by `factor`, and its variable (start included) by `stretch` > 0.
template <class Over>
Curve<Over> scaled(const Curve<Over>& f, double factor, double stretch = 1);

/// f backwards over the same interval: g(start + u) = f(end - u).
template <class Over>
Curve<Over> reversed(const Curve<Over>& f);

/// f, then g, which begins at the end of f. Values do not change: a step of the value stays, and
/// check_continuity() finds it. The result has the policy of f outside.
template <class Over>
Curve<Over> concatenated(const Curve<Over>& f, const Curve<Over>& g);

/// f, repeated `times` >= 1 times.
template <class Over>
Curve<Over> repeated(const Curve<Over>& f, int times);

/// f + g over the same interval, with the breaks of f and g. Throws InputError if a piece needs
/// more than three sines, or if the intervals differ by more than rounding.
template <class Over>
Curve<Over> sum(const Curve<Over>& f, const Curve<Over>& g);

/// f with another policy outside.
template <class Over>
Curve<Over> with(const Curve<Over>& f, Extrapolation outside);

extern template class Curve<OverTime>;
extern template class Curve<OverMaster>;

}  // namespace jounce
