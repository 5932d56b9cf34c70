// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/break_index.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// An immutable piecewise function of one scalar: the result of every generator, and the input of
/// every check, sampler, validator and stream.
///
///     Trajectory move = trapezoid({.to = 50, .velocity = 10, .acceleration = 20}).curve();
///     Motion now = move.at(0.25);               // position, velocity, acceleration, jerk
///     Range v = extrema(move, 1);               // exact: where and how fast at most
///     Trajectory back = reversed(move);
///     Trajectory both = concatenated(move, back);
///     Report report = check(both, {.velocity = 10});
///
/// **Vocabulary.** The curve runs over time (a Trajectory) or over master position (a Cam). A
/// *segment* is one formula; the *breaks* are the points where segments meet, start and end
/// included, so there is one more break than segments. Segments store lengths; breaks are their
/// running sum.
///
/// **Intervals.** Segments are half-open, the last one closed: at a break the curve takes the value
/// of the segment that begins there (right-continuous). Side::left asks for the other limit.
///
/// **Outside [start, end]** the policy given at construction applies: refuse, hold, wrap, or
/// advance.
///
/// **Throws** InputError if there is no segment, a length is not finite and positive, a coefficient
/// is not finite, or start is not finite or so distant that rounding removes a whole length.
/// Nothing else throws; evaluation never allocates.
template <class Over>
class Curve {
 public:
  using Point = typename Over::Point;

  explicit Curve(std::vector<Segment> segments, double start = 0,
                 Extrapolation outside = Extrapolation::refuse);

  [[nodiscard]] double start() const { return breaks_.front(); }
  [[nodiscard]] double end() const { return breaks_.back(); }
  [[nodiscard]] double length() const { return end() - start(); }
  [[nodiscard]] Extrapolation outside() const { return outside_; }
  /// Advance of the value in one period: Extrapolation::advance; otherwise 0.
  [[nodiscard]] double advance() const;
  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }

  /// Value with three derivatives.
  [[nodiscard]] Jet jet(double x, Side side = Side::right) const;
  [[nodiscard]] Point at(double x, Side side = Side::right) const {
    return point<Over>(jet(x, side));
  }

  /// A block of points: the same as at() for each x, faster if x ascends. Spans of equal size.
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

/// d/dx of the curve, as a curve of the same kind.
template <class Over>
Curve<Over> derivative(const Curve<Over>& f);

/// The integral from start(), beginning at start_value, continuous at every break. Throws
/// InputError if a segment already has degree 11.
template <class Over>
Curve<Over> integral(const Curve<Over>& f, double start_value = 0);

/// The same shape moved along the axis by dx, and in value by dy.
template <class Over>
Curve<Over> shifted(const Curve<Over>& f, double dx, double dy = 0);

/// The value times `factor`, the axis (start included) times `stretch` > 0.
template <class Over>
Curve<Over> scaled(const Curve<Over>& f, double factor, double stretch = 1);

/// Run backwards over the same interval: g(start + u) = f(end - u).
template <class Over>
Curve<Over> reversed(const Curve<Over>& f);

/// f, then g from the end of f on the axis. Values are not moved: a jump is kept (and `check` finds
/// it). The policy outside is f's.
template <class Over>
Curve<Over> concatenated(const Curve<Over>& f, const Curve<Over>& g);

/// f, `times` >= 1 times, one after another.
template <class Over>
Curve<Over> repeated(const Curve<Over>& f, int times);

/// f + g over the same interval, with the breaks of both. Throws InputError if a sum needs more
/// than three sines or the intervals differ by more than rounding.
template <class Over>
Curve<Over> sum(const Curve<Over>& f, const Curve<Over>& g);

/// The same segments under another policy outside.
template <class Over>
Curve<Over> with(const Curve<Over>& f, Extrapolation outside);

extern template class Curve<OverTime>;
extern template class Curve<OverMaster>;

}  // namespace jounce
