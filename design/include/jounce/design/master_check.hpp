// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/cam/coupling/slave_check.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// A cam of a spec against [limits.slave], the limits of the slave over time.
bool has_slave_limits(const Spec& spec);

/// Motion of the master of the spec, in addition to its speed; at rest if there is none.
MasterRates master_rates(const Spec& spec);

/// Unit of the `order`th derivative of the master by time.
std::string master_rate_unit(const Spec& spec, int order);

/// The unit in which the spec gives the speed of its master, and its size in master_rate_unit(): "rpm", "cpm" for
/// cycles, otherwise master_rate_unit() itself.
struct SpeedUnit {
  std::string name;
  double size = 1;
};
SpeedUnit master_speed_unit(const Spec& spec);

/// The unit in which the spec gives the limit of the `order`th derivative over time: "m/s^2". For a plain number, the
/// unit that follows from [units].
std::string slave_rate_unit(const Spec& spec, int order);

/// The slave over time against [limits.slave], behind the [master] of the spec: see check_slave(). Values in
/// slave_rate_unit().
Report check_slave(const Cam& cam, const Spec& spec);

/// True if the master's own acceleration breaks a limit of the slave already at its start: a slower
/// master would not help.
bool master_accelerates_too_fast(const Cam& cam, const Spec& spec);

/// Its limit at the speed of [master] of the spec, if any; otherwise at any speed.
MasterLimit greatest_master_acceleration(const Cam& cam, const Spec& spec);

/// True if the spec's [master] is slow enough for the slave.
Finding master_finding(const Cam& cam, const Spec& spec);

}  // namespace jounce
