// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"

#include "cam/src/design/taylor.hpp"

namespace jounce::cam_detail {

/// An interval of a curve: a segment of it, from s0 to s1 in [0, 1]; a single point if they are
/// equal.
struct SegmentPart {
  std::size_t segment = 0;
  double s0 = 0;
  double s1 = 1;

  [[nodiscard]] double middle() const { return (s0 + s1) / 2; }
  [[nodiscard]] SegmentPart left() const { return {segment, s0, middle()}; }
  [[nodiscard]] SegmentPart right() const { return {segment, middle(), s1}; }
  [[nodiscard]] SegmentPart at(double s) const { return {segment, s, s}; }
};

/// The position on the curve's axis that belongs to s of a segment; exact at the ends of the
/// segment.
double position(const Cam& f, std::size_t segment, double s);

/// f and four derivatives over an interval, with respect to x = angle * (position on the curve's
/// axis).
Taylor<4> enclosure(const Cam& f, const SegmentPart& over, double angle);

/// A function of the curve: its value with two derivatives over an interval, by x as above.
using Observed = std::function<Taylor<2>(const SegmentPart&)>;

/// A value, and the excess of its upper bound.
struct Certified {
  Extremum extremum;
  double excess = 0;  ///< the true maximum is at most this much greater
};

/// The greatest value of `observed` over the curve, including both sides of every break; of equal
/// values, the first. Found by branch and bound, to 1e-13 of the magnitude of the values (or of
/// `scale`, if that is more). If the rounding of a value exceeds that, `excess` includes it.
Certified maximum(const Cam& f, double angle, const Observed& observed, double scale);

}  // namespace jounce::cam_detail
