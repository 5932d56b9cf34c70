// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/cam/coupling/slave_check.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// True if a cam spec has [limits.slave], the limits of the slave over time.
bool has_slave_limits(const Spec& spec);

/// Acceleration and jerk of the spec's master, in addition to its speed; 0 if there is no [master].
MasterRates master_rates(const Spec& spec);

/// Unit of the derivative of this order of the master's position with respect to time.
std::string master_rate_unit(const Spec& spec, int order);

/// The unit in which the spec gives the speed of its master, and its size in master_rate_unit().
struct SpeedUnit {
  std::string name;  ///< "rpm"; "cpm" for cycles; otherwise master_rate_unit() itself
  double size = 1;
};
SpeedUnit master_speed_unit(const Spec& spec);

/// The unit in which the spec gives the limit of the derivative of this order over time: "m/s^2". If
/// the limit is a number without a unit, this is the unit that follows from [units].
std::string slave_rate_unit(const Spec& spec, int order);

/// Compares the slave over time, behind the [master] of the spec, with [limits.slave]: see
/// check_slave() in jounce/cam. Values are in slave_rate_unit().
Report check_slave(const Cam& cam, const Spec& spec);

/// True if the acceleration of the master alone breaks a limit of the slave, already at its start,
/// so that a slower master would not help.
bool master_accelerates_too_fast(const Cam& cam, const Spec& spec);

/// The greatest acceleration of the master, at the speed of [master] if there is one, otherwise at
/// any speed.
MasterLimit greatest_master_acceleration(const Cam& cam, const Spec& spec);

/// A speed of the master, and an acceleration with which it may reach it.
struct MasterSpeed {
  double velocity = 0;
  double acceleration = 0;
};
/// A speed and an acceleration of the master that keep the limits of the slave together: the speed
/// of [master] if an acceleration is left for it, otherwise half of the greatest acceleration at
/// rest, and the greatest speed with it.
MasterSpeed fastest_master_with_ramp(const Cam& cam, const Spec& spec);

/// The finding that compares the speed of the spec's [master] with the greatest speed at which the
/// slave stays within its limits.
Finding master_finding(const Cam& cam, const Spec& spec);

}  // namespace jounce
