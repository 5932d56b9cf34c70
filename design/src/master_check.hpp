// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// A cam of a spec against [limits.slave], the limits of the slave over time.
bool has_slave_limits(const Spec& spec);

/// Motion of the master of the spec, in addition to its speed; at rest if there is none.
MasterRates master_rates(const Spec& spec);

/// Unit of the `order`th derivative of the master by time.
std::string master_rate_unit(const Spec& spec, int order);

/// True if the master's own acceleration breaks a limit of the slave already at its start: a slower
/// master would not help.
bool master_accelerates_too_fast(const Cam& cam, const Spec& spec);

/// Its limit at the speed of [master] of the spec, if any; otherwise at any speed.
MasterLimit greatest_master_acceleration(const Cam& cam, const Spec& spec);

/// True if the spec's [master] is slow enough for the slave.
Finding master_finding(const Cam& cam, const Spec& spec);

}  // namespace jounce
