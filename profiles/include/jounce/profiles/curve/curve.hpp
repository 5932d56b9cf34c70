// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/break_index.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/curve/segment.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// An immutable piecewise function of one variable. Every generator of motions returns a curve.
/// Checks, samplers, validators and streams read curves.
///
///     Trajectory move = trapezoid({.to = 50, .velocity = 10, .acceleration = 20}).curve();
///     Motion now = move.at(0.25);               // position, velocity, acceleration, jerk
///     Range v = extrema(move, 1);               // exact: extreme velocities and their times
///     Trajectory back = reversed(move);
///     Trajectory both = concatenated(move, back);
///     Report report = check(both, {.velocity = 10});
///
/// **Vocabulary.** The *variable* of a curve is time (a Trajectory) or the master's position (a
/// Cam). A *segment* is one formula. The *breaks* are the start, the points where segments meet,
/// and the end, so a curve has one more break than segments. Segments store their lengths; a break
/// is the start plus the sum of the lengths before it.
///
/// **Intervals.** A segment includes its start but not its end. So at a break the curve has the
/// value of the segment that begins there (right-continuous). Side::left selects the limit from the
/// left. The end of the curve belongs to the last segment; but if the curve is periodic,
/// Side::right gives the start of the next period.
///
/// **Outside [start, end]**, the policy given to the constructor applies; see Extrapolation in
/// jet.hpp. At NaN, the value and all derivatives are NaN; for a periodic curve also at infinity.
///
/// **Throws.** The constructor throws InputError if there is no segment, if a length is not finite
/// and positive, if a degree or a number of sines is out of range, if the value or one of the first
/// four derivatives of a segment is not finite (a coefficient is not finite, or a double cannot
/// hold the derivative), if start or end is not finite, or if start is so large that start + length
/// rounds to start. Other members do not throw, except sample() for spans of different sizes; the
/// functions below throw if their result breaks these rules. Evaluation never allocates.
///
/// **A curve that was moved from** is empty: assign to it or destroy it, but call no other member.
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

  /// Writes at(x[i]) to out[i] for all i. Throws InputError if the spans differ in size. Fastest if
  /// x ascends.
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

// ---- algebra: each function returns a new curve over the same variable -------------------------

/// Returns the first derivative. The result has the policy of f, except that the policy `advance`
/// becomes `wrap`.
template <class Over>
Curve<Over> derivative(const Curve<Over>& f);

/// Returns the integral of f, which has the value `start_value` at start(), is continuous at every
/// break, and has the policy of f. Throws InputError if a segment already has degree 11.
template <class Over>
Curve<Over> integral(const Curve<Over>& f, double start_value = 0);

/// Returns f moved by dx along its variable and by dy in its value.
template <class Over>
Curve<Over> shifted(const Curve<Over>& f, double dx, double dy = 0);

/// Returns f with its value multiplied by `factor`, and its variable (start included) by `stretch`.
/// Throws InputError unless stretch > 0.
template <class Over>
Curve<Over> scaled(const Curve<Over>& f, double factor, double stretch = 1);

/// Returns f backwards over the same interval: g(start + u) = f(end - u).
template <class Over>
Curve<Over> reversed(const Curve<Over>& f);

/// Returns f followed by g, which is moved along the variable to begin at the end of f. Values do
/// not change: if g begins with another value, the result has a step, which check_continuity()
/// (limits/limits.hpp) reports. The result has the policy of f.
template <class Over>
Curve<Over> concatenated(const Curve<Over>& f, const Curve<Over>& g);

/// Returns f repeated `times` times, one after the other, with unchanged values and the policy of
/// f. Throws InputError if times < 1.
template <class Over>
Curve<Over> repeated(const Curve<Over>& f, int times);

/// Returns f + g over their common interval, with the breaks of both curves and the policy of f.
/// Throws InputError if a piece needs more than three sines, or if the intervals of f and g differ
/// by more than rounding.
template <class Over>
Curve<Over> sum(const Curve<Over>& f, const Curve<Over>& g);

/// Returns f with another policy outside its interval.
template <class Over>
Curve<Over> with(const Curve<Over>& f, Extrapolation outside);

extern template class Curve<OverTime>;
extern template class Curve<OverMaster>;

}  // namespace jounce
