// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "jounce/path/path.hpp"
#include "jounce/profiles/curve/segment.hpp"

// The corner of any two pieces: for each axis, a quintic over the length 2 d in q. At both ends it
// has the position, direction and curvature of the adjacent piece, at the distance d before and
// after the corner (docs/path/README.md, "Blends").
namespace jounce {

struct Blend {
  std::array<Segment, max_axes> axes;
  std::size_t count = 0;
  double trim = 0;

  [[nodiscard]] std::span<const Segment> segments() const { return std::span(axes).first(count); }
};

/// The blend of piece k and piece k + 1.
Blend blend_of(const Path& route, std::size_t k, double trim);

/// Least distance of polynomial segments from a point, over the first n axes. Exact: an extremum of
/// a polynomial of degree 10.
double least_distance(std::span<const Segment> axes, const Point& p, std::size_t n);

/// The greatest |r''| over all given axes. Exact.
double greatest_bend(std::span<const Segment> axes);

/// The greatest |r'| over the first n axes. Exact.
double greatest_speed(std::span<const Segment> axes, std::size_t n);

/// Greatest magnitudes of the first three derivatives of one axis with respect to q. Exact.
struct AxisPeaks {
  double direction = 0, curvature = 0, rate = 0;
};
AxisPeaks peaks_of(const Segment& axis);

/// Greatest curvature over the first n axes, to about 1e-9 of it. Found by search; for reports.
double greatest_curvature(std::span<const Segment> axes, std::size_t n);

/// Upper bound of the distance of a blend from both pieces: of its first half from the piece
/// before, of its second half from the piece after. Exact for lines and circles.
double distance_from_sides(const Path& route, std::size_t k, const Blend& blend, std::size_t n);

}  // namespace jounce
