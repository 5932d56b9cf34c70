// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "jounce/path/path.hpp"
#include "jounce/profiles/curve/segment.hpp"

// The corner of any two pieces: a quintic an axis that takes position, direction and curvature of both at the same
// distance d before and behind the corner, over 2 d of q (docs/path/README.md, "Blends").
namespace jounce {

struct Blend {
  std::array<Segment, max_axes> axes;
  std::size_t count = 0;
  double trim = 0;

  [[nodiscard]] std::span<const Segment> segments() const { return std::span(axes).first(count); }
};

/// The blend of piece k and the next one.
Blend blend_of(const Path& route, std::size_t k, double trim);

/// Least distance of polynomial segments from a point over the first n axes: exact, an extremum of degree 10.
double least_distance(std::span<const Segment> axes, const Point& p, std::size_t n);

/// The greatest |r'| over the first n axes: exact.
double greatest_speed(std::span<const Segment> axes, std::size_t n);

/// Greatest magnitude of the first three derivatives by q of one axis: exact.
struct Peaks {
  double direction = 0, curvature = 0, rate = 0;
};
Peaks peaks_of(const Segment& axis);

/// Greatest curvature over the first n axes, to about 1e-9 of it: searched, for reports.
double greatest_curvature(std::span<const Segment> axes, std::size_t n);

/// Upper bound of the distance of a blend from the two pieces: the first half from the piece before, the second
/// from the piece behind; exact for lines and circles.
double distance_from_sides(const Path& route, std::size_t k, const Blend& blend, std::size_t n);

}  // namespace jounce
