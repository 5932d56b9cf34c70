// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/optimize/problem.hpp"

namespace jounce {

/// A interval of a cam between two knots that cannot change: how long, how far, and the derivatives
/// by master at its ends. An acceleration left out is free.
struct KnotInterval {
  double length = 1;        ///< m, > 0
  double displacement = 0;  ///< u
  double v0 = 0;            ///< u/m
  double v1 = 0;
  std::optional<double> a0;  ///< u/m^2
  std::optional<double> a1;
};

/// The least max |f''| of any function over the interval, optionally with |f'| <= velocity_limit;
/// infinite if no function keeps that limit. Attained by full acceleration, coast, full
/// deceleration; from rest to rest 4 h / L^2. End accelerations do not matter: they can be changed
/// at once.
double least_peak_acceleration(const KnotInterval& interval,
                               std::optional<double> velocity_limit = {});

/// The least max |f'''| of any function over the interval: that of the perfect spline, whose third
/// derivative is +-J with as many switches as end accelerations are given. From rest to rest with
/// accelerations 0: 32 h / L^3.
double least_peak_jerk(const KnotInterval& interval);

/// The least integral of f''^2: that of the cubic. From rest to rest 12 h^2 / L^3.
double least_square_acceleration(const KnotInterval& interval);

/// The least max |f' f''|, the peak power of a pure inertia: that of constant power, which is put in and
/// then taken out again (9/4 h^2 / L^3 from rest to rest). End accelerations do not matter.
double least_peak_power(const KnotInterval& interval);

/// Bound for every choice of the free quantities, and for all laws between the fixed
/// knots: the cam is cut at the knots whose master, slave and geo_velocity are fixed; each interval
/// has the bound above, or that of the places it passes where their slave is fixed; each segment without
/// freedom has its exact value. A first or last interval whose
/// outer end is free counts zero. Infinite if the velocity limit cannot be kept (for
/// peak_acceleration only). Holds for each objective alone.
double lower_bound(const CamProblem& problem, Objective objective);

}  // namespace jounce
