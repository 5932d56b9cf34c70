// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include "jounce/path/group_limits.hpp"
#include "jounce/path/path.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/path/program.hpp"

// Limits as numbers, and the resulting limits of the law on each piece of a path.
namespace jounce {

/// Limits of the axes and of the path: magnitudes, infinite if there is no limit.
struct Rates {
  std::size_t axes = 0;
  std::size_t path_axes = 0;
  std::array<double, max_axes> velocity{}, acceleration{}, jerk{};
  PathLimits path;
  const std::atomic<bool>* canceled = nullptr;  ///< PlanOptions::canceled

  /// Throws PlanCanceled if the plan is canceled. Long loops call it.
  void require_wanted() const {
    if (canceled != nullptr && canceled->load(std::memory_order_relaxed)) throw PlanCanceled();
  }
};

/// Converts the limits. Throws InputError if they do not fit the program.
Rates rates_of(const GroupLimits& limits, std::size_t axes, std::size_t path_axes);

/// The limits for a piece that is not a line. Limits of axes and of the normal and total
/// acceleration are reduced by the share `fit_share`, which to_axes() needs for the error of its
/// fits and for rounding.
constexpr double fit_share = 1e-6;
Rates reserved(const Rates& rates);

/// Any law with -deceleration <= q'' <= acceleration, |q'''| <= jerk and q' + q''^2 / 2 jerk <=
/// velocity stays within all limits on the piece. Every ramp that ends at this velocity or below,
/// with zero acceleration, is such a law. On a corner, the law has constant velocity,
/// except in a chain of turns (turn_chains.hpp).
struct Box {
  double velocity = PathSettings::none;
  double acceleration = PathSettings::none;
  double deceleration = PathSettings::none;
  double jerk = PathSettings::none;
  bool constant = false;
};

/// The box of a line with this direction.
Box line_box(const Rates& rates, const PathSettings& settings, const double* direction);

/// True for a rounded corner.
inline bool is_corner(const PathPiece& piece) {
  return piece.kind == PieceKind::turn || piece.kind == PieceKind::blend;
}

/// The feed on a piece. A corner belongs to two commands: the lower feed of both.
inline double feed_of(const PathPiece& piece, std::span<const PathSettings> settings) {
  const double feed = settings[piece.settings].velocity;
  return is_corner(piece) ? std::min(feed, settings[piece.settings_before].velocity) : feed;
}

/// True if a command has limits of axes.
bool limit_axes(std::span<const PathSettings> settings);

/// The limits on a piece: those of its command lower `rates`. On a corner, those of both commands.
Rates rates_on(Rates rates, const PathPiece& piece, std::span<const PathSettings> settings,
               bool corner);

/// The box from the limits of the path and the settings alone.
Box path_box(const Rates& rates, const PathSettings& settings);

/// The box of an arc or a helix. `length`: distance that the law covers on it. `entry` and `exit`:
/// greatest velocities at its ends; 0 is a rest. The box is a compromise between velocity and
/// acceleration; see arc_box.cpp.
Box arc_box(const Rates& rates, const PathSettings& settings, const double* numbers, double length,
            double entry, double exit);

/// Boxes for successive parts of an arc: low velocity and high acceleration at its ends, high
/// velocity in the middle.
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

/// The parts of an arc of the length `whole`, of which the law covers `length`: a single part, or
/// several (stairs) if they are faster.
ArcZones arc_zones(const Rates& rates, const PathSettings& settings, const double* numbers,
                   double whole, double length, double entry, double exit);

/// Bounds of |r'|, |r''| and |r'''| of each axis over a piece (derivatives with respect to q), and of
/// the vectors of the path axes. The latter do not depend on the directions of the axes.
struct Derivatives {
  std::array<double, max_axes> first{}, second{}, third{};
  double speed = 1;  ///< |r'|, at least 1
  double bend = 0;   ///< |r''|
  double along = 0;  ///< |r' r''|, the scalar product

  /// Bound of the square of the acceleration |r' a + r'' v^2|.
  [[nodiscard]] double acceleration_squared(double a, double v) const {
    return speed * speed * a * a + (2 * along * a + bend * bend * v * v) * v * v;
  }
};
/// Bounds the vectors of a piece from the polynomials of its path axes.
void bound_vectors(std::span<const Segment> axes, Derivatives& bounds);
Derivatives derivatives_of(const Path& path, std::size_t piece, std::size_t path_axes);

/// The greatest velocity that stays within the limits on a piece for all |q''| <= acceleration and
/// |q'''| <= jerk; negative if there is none.
double velocity_with(const Rates& rates, const Derivatives& bounds, double acceleration,
                     double jerk);

/// The box of a piece of a polynomial path; the law may be any law within the box.
Box curve_box(const Rates& rates, const PathSettings& settings, const Derivatives& bounds,
              double length);

/// The box of a polynomial piece that is passed at constant velocity.
Box blend_box(const Rates& rates, std::span<const Segment> axes);

}  // namespace jounce
