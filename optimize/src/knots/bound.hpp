// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/optimize/problem.hpp"

namespace jounce {

/// An interval of a cam between two fixed knots: its length, its displacement, and the derivatives
/// with respect to the master at both ends. u is the unit of the slave, m the unit of the master.
struct KnotInterval {
  double length = 1;         ///< length, m, > 0
  double displacement = 0;   ///< displacement of the slave, u
  double v0 = 0;             ///< geo_velocity at the start, u/m
  double v1 = 0;             ///< geo_velocity at the end, u/m
  std::optional<double> a0;  ///< geo_acceleration at the start, u/m^2; nullopt: free
  std::optional<double> a1;  ///< geo_acceleration at the end, u/m^2; nullopt: free
};

/// Returns the least possible max |f''| of any function f over the interval, u/m^2; if
/// `velocity_limit` (u/m) is given, of any function with |f'| <= velocity_limit. Infinite if no
/// function satisfies this limit. The optimal motion consists of full acceleration, constant
/// velocity and full deceleration; from rest to rest without a limit its peak is 4 h / L^2 (h:
/// displacement, L: length). Given accelerations at the ends have no influence, because f'' may
/// step.
double least_peak_acceleration(const KnotInterval& interval,
                               std::optional<double> velocity_limit = {});

/// Returns the least possible max |f'''| of any function over the interval, u/m^3. The optimal
/// motion is the perfect spline: its third derivative is +J or -J, with as many switches as
/// accelerations are given at the ends. From rest to rest with accelerations 0, the result is 32 h
/// / L^3.
double least_peak_jerk(const KnotInterval& interval);

/// Returns the least possible integral of f''^2, u^2/m^3. The optimal motion is the cubic; from
/// rest to rest the result is 12 h^2 / L^3.
double least_square_acceleration(const KnotInterval& interval);

/// Returns the least possible max |f' f''|, u^2/m^3: the peak power of a pure inertia. The optimal
/// motion first adds and then removes energy at constant power; from rest to rest the result is 9/4
/// h^2 / L^3. Given accelerations at the ends have no influence.
double least_peak_power(const KnotInterval& interval);

/// Returns a lower bound of the objective, for all values of the free quantities and all laws
/// between the fixed knots. The bound is for the case that this objective alone is minimized.
///
/// The cam is divided at the knots whose master, slave and geo_velocity are fixed. The bound of
/// each interval is the result of the function above that belongs to the objective. The bound of a
/// peak is the greatest bound of the intervals. The bound of the rms acceleration is sqrt(s / L),
/// with the sum s of the bounds of the intervals (least_square_acceleration()) and the length L of
/// the cam. If the slave is fixed at knots within the interval, the bound also accounts for these
/// points. A segment without free quantities has its exact value. A first or last interval whose
/// outer end is free counts as 0. If no cam can satisfy the velocity limit, the result is infinite
/// (for peak_acceleration only).
double lower_bound(const CamProblem& problem, Objective objective);

}  // namespace jounce
