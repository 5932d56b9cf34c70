// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/master_check.hpp"

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {

bool has_slave_limits(const Spec& spec) {
  const Limits& slave = spec.slave;
  return slave.velocity || slave.acceleration || slave.jerk;
}

std::string master_rate_unit(const Spec& spec, int order) {
  return rate_unit(spec.units.x, spec.time_unit, order);
}

MasterRates master_rates(const Spec& spec) {
  if (!spec.master) return {};
  return {spec.master->acceleration.value_or(0), 0};
}

bool master_accelerates_too_fast(const Cam& cam, const Spec& spec) {
  const double given = master_rates(spec).acceleration;
  const double most = greatest_master_acceleration(cam, spec.slave, 0).value;
  return given > most && greatest_master_velocity(cam, spec.slave).value > 0;
}

MasterLimit greatest_master_acceleration(const Cam& cam, const Spec& spec) {
  const Limits& slave = spec.slave;
  const MasterLimit running = greatest_master_acceleration(cam, slave, spec.master->velocity);
  return running.value > 0 ? running : greatest_master_acceleration(cam, slave, 0);
}

namespace {

Finding acceleration_finding(const Cam& cam, const Spec& spec) {
  const MasterLimit limit = greatest_master_acceleration(cam, spec);
  Finding f;
  f.rule = "limit/master_acceleration";
  f.quantity = "master_acceleration";
  f.where = limit.where;
  f.value = master_rates(spec).acceleration;
  f.limit = limit.value;
  f.margin = limit.value > 0 ? 1 - f.value / limit.value : -f.value;
  f.broken = true;
  f.unit = master_rate_unit(spec, 2);
  f.advice = fmt::format(
      "the slave reaches limits.slave.{0} at any speed of the master: lower acceleration in "
      "[master] to at most {1}",
      limit.quantity, rounded(limit.value));
  const double steady = greatest_master_velocity(cam, spec.slave).value;
  if (spec.master->velocity > steady)
    f.advice += fmt::format(", and velocity to at most {}", rounded(steady));
  return f;
}

}  // namespace

Finding master_finding(const Cam& cam, const Spec& spec) {
  if (master_accelerates_too_fast(cam, spec)) return acceleration_finding(cam, spec);
  const double speed = spec.master->velocity;
  const MasterLimit limit = greatest_master_velocity(cam, spec.slave, master_rates(spec));
  Finding f;
  f.rule = "limit/master_velocity";
  f.quantity = "master_velocity";
  f.where = limit.where;
  f.value = speed;
  f.limit = limit.value;
  f.margin = limit.value > 0 ? 1 - speed / limit.value : -speed;
  f.broken = speed > limit.value * (1 + 1e-12);
  f.unit = master_rate_unit(spec, 1);
  if (f.broken)
    f.advice = "there the slave reaches limits.slave." + limit.quantity + ": slow the master down";
  return f;
}

}  // namespace jounce
