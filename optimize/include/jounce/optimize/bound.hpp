// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/optimize/problem.hpp"

namespace jounce {

/// An interval of a cam between two knots that cannot change: its length, its displacement, and the
/// derivatives with respect to the master at both ends. Units: u is the unit of the slave, m that
/// of the master.
struct KnotInterval {
  double length = 1;         ///< length, m, > 0
  double displacement = 0;   ///< displacement of the slave, u
  double v0 = 0;             ///< geo_velocity at the start, u/m
  double v1 = 0;             ///< geo_velocity at the end, u/m
  std::optional<double> a0;  ///< geo_acceleration at the start, u/m^2; nullopt: free
  std::optional<double> a1;  ///< geo_acceleration at the end, u/m^2; nullopt: free
};

/// Returns the least possible max |f''| of any function f over the interval, u/m^2; with
/// `velocity_limit` (u/m), under the condition |f'| <= velocity_limit. Infinite if no function
/// keeps that limit. The least peak is reached by full acceleration, constant velocity, full
/// deceleration; from rest to rest it is 4 h / L^2 (h: displacement, L: length). Accelerations at
/// the ends have no influence, since a function may change its acceleration at once.
double least_peak_acceleration(const KnotInterval& interval,
                               std::optional<double> velocity_limit = {});

/// Returns the least possible max |f'''| of any function over the interval, u/m^3. The perfect
/// spline reaches it: its third derivative is +J or -J, with as many switches as accelerations are
/// given at the ends. From rest to rest with accelerations 0, it is 32 h / L^3.
double least_peak_jerk(const KnotInterval& interval);

/// Returns the least possible integral of f''^2. The cubic reaches it; from rest to rest it is 12
/// h^2 / L^3.
double least_square_acceleration(const KnotInterval& interval);

/// Returns the least possible max |f' f''|, the peak power of a pure inertia. A motion reaches it
/// that first adds and then removes energy at constant power; from rest to rest it is 9/4 h^2 /
/// L^3. Accelerations at the ends have no influence.
double least_peak_power(const KnotInterval& interval);

/// Returns a lower bound of the objective for all values of the free quantities, and for all laws
/// between the fixed knots. It holds for each objective alone.
///
/// The cam is divided at the knots whose master, slave and geo_velocity are fixed. The bound of
/// each interval is the least value above. If the slave is fixed at knots within the interval, the
/// bound for passing these points is used. A segment without free quantities has its exact value. A
/// first or last interval whose outer end is free counts as 0. The result is infinite if the
/// velocity limit cannot be kept (for peak_acceleration only).
double lower_bound(const CamProblem& problem, Objective objective);

}  // namespace jounce
