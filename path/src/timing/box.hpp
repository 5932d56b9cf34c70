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

/// Any law with -deceleration <= q'' <= acceleration, |q'''| <= jerk and q' + q''^2 / 2 jerk <=
/// velocity keeps all limits on the piece. Every ramp that ends at this velocity or below, with
/// zero acceleration, is such a law. On a corner, the law has constant velocity.
struct Box {
  double velocity = PathSettings::none;
  double acceleration = PathSettings::none;
  double deceleration = PathSettings::none;
  double jerk = PathSettings::none;
  bool constant = false;
};

/// A line with this direction.
Box line_box(const Rates& rates, const PathSettings& settings, const double* direction);

/// The box of path limits and settings alone.
Box path_box(const Rates& rates, const PathSettings& settings);

/// An arc or a helix. `length`: distance of the law on it; `entry` and `exit`: greatest velocities at
/// its ends, 0 for a rest. The box is a compromise of velocity and acceleration; see arc_box.cpp.
Box arc_box(const Rates& rates, const PathSettings& settings, const double* numbers, double length,
            double entry, double exit);

/// Boxes for successive parts of an arc: slow ones with much acceleration at its ends, a fast one in the middle.
struct ArcZones {
  struct Zone {
    double length = 0;
    Box box;
  };
  std::array<Zone, 9> zone{};
  std::size_t count = 0;

  void add(const Zone& next) { zone[count++] = next; }
  void add(double length, const Box& box) { add({length, box}); }
  [[nodiscard]] const Zone& last() const { return zone[count - 1]; }
};

/// The parts of an arc of `whole` length of which the law goes over `length`: one, or stairs where they are faster.
ArcZones arc_zones(const Rates& rates, const PathSettings& settings, const double* numbers,
                   double whole, double length, double entry, double exit);

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
