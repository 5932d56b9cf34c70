// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "jounce/path/group_limits.hpp"
#include "jounce/path/path.hpp"
#include "jounce/path/program.hpp"

// Limits as numbers, and what they leave of the law on a piece of a path.
namespace jounce {

/// Magnitudes by axis, infinite where there is none; and those of the path.
struct Rates {
  std::size_t axes = 0;
  std::size_t path_axes = 0;
  std::array<double, max_axes> velocity{}, acceleration{}, jerk{};
  PathLimits path;
};

/// Throws InputError for limits that do not fit the program.
Rates rates_of(const GroupLimits& limits, std::size_t axes, std::size_t path_axes);

/// The limits of axes, normal and total acceleration for a piece that is not a line: less by the share that `to_axes`
/// needs for the error of its fits and for rounding.
constexpr double fit_share = 1e-6;
Rates reserved(const Rates& rates);

/// Any law with q' <= velocity, -deceleration <= q'' <= acceleration and |q'''| <= jerk keeps all limits on
/// the piece. On a corner the law is at constant velocity.
struct Box {
  double velocity = PathSettings::none;
  double acceleration = PathSettings::none;
  double deceleration = PathSettings::none;
  double jerk = PathSettings::none;
  bool constant = false;
};

/// A line with this direction.
Box line_box(const Rates& rates, const PathSettings& settings, const double* direction);

/// An arc or a helix; `length` is how far the law goes on it, `entry` and `exit` are the greatest velocities at its ends,
/// 0 for a rest. A compromise of velocity and acceleration, see box.cpp.
Box arc_box(const Rates& rates, const PathSettings& settings, const double* numbers, double length,
            double entry, double exit);

/// Bounds of the derivatives of each axis by q over a piece: |r'|, |r''|, |r'''|.
struct Derivatives {
  std::array<double, max_axes> first{}, second{}, third{};
  double speed = 1;  ///< |r'| over the path axes, at least 1
};
Derivatives derivatives_of(const Path& path, std::size_t piece, std::size_t path_axes);

/// The greatest velocity with any |q''| <= acceleration and |q'''| <= jerk on a piece; negative if there is none.
double velocity_with(const Rates& rates, const Derivatives& bounds, double acceleration,
                     double jerk);

/// A piece of a polynomial path, on which the law may do anything within the box.
Box curve_box(const Rates& rates, const PathSettings& settings, const Derivatives& bounds,
              double length);

/// Polynomial piece at constant velocity.
Box blend_box(const Rates& rates, std::span<const Segment> axes);

}  // namespace jounce
