// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// True if a cam spec has [limits.slave], the limits of the slave over time.
bool has_slave_limits(const Spec& spec);

/// Acceleration and jerk of the spec's master, in addition to its speed; 0 if there is no [master].
MasterRates master_rates(const Spec& spec);

/// Unit of the derivative of this order of the master's position with respect to time.
std::string master_rate_unit(const Spec& spec, int order);

/// True if the acceleration of the master alone breaks a limit of the slave, already at its start,
/// so that a slower master would not help.
bool master_accelerates_too_fast(const Cam& cam, const Spec& spec);

/// The greatest acceleration of the master, at the speed of [master] if there is one, otherwise at
/// any speed.
MasterLimit greatest_master_acceleration(const Cam& cam, const Spec& spec);

/// The finding that compares the speed of the spec's [master] with the greatest speed at which the
/// slave keeps its limits.
Finding master_finding(const Cam& cam, const Spec& spec);

}  // namespace jounce
