// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/himc/himc_gear.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace jounce::himc {
namespace {

bool is_axis(int axis) {
  return axis >= 0 && axis < axis_count;
}

GearAxis& at(Gears& gears, int axis) {
  assert(is_axis(axis));
  return gears.axis[static_cast<std::size_t>(axis)];
}
const GearAxis& at(const Gears& gears, int axis) {
  assert(is_axis(axis));
  return gears.axis[static_cast<std::size_t>(axis)];
}

/// Error in the two axes of a pair, whether or not it is engaged.
GearError wrong_with(const Gears& gears, int master, int slave) {
  if (!is_axis(slave)) return GearError::bad_slave;
  if (!is_axis(master) || master == slave) return GearError::bad_link;
  if (!at(gears, master).enabled || !at(gears, slave).enabled) return GearError::disabled;
  if (at(gears, slave).in_cam) return GearError::in_cam;
  return GearError::ok;
}

}  // namespace

const char* explain(GearError error) {
  switch (error) {
    case GearError::ok:
      return "";
    case GearError::disabled:
      return "Both axes of a gear must be enabled.";
    case GearError::synchronized:
      return "The slave is engaged: GearOut comes before DisableGear.";
    case GearError::is_master:
      return "The axis is a gear master, and cannot be a slave as well.";
    case GearError::bad_link:
      return "These two axes cannot be master and slave.";
    case GearError::bad_slave:
      return "The slave is not an axis.";
    case GearError::bad_ratio:
      return "The gear ratio must be finite and not 0.";
    case GearError::not_enabled:
      return "The gear is not enabled: EnableGear comes first.";
    case GearError::in_cam:
      return "The slave follows a cam.";
  }
  return "";
}

GearAnswer enable_gear(const Gears& gears, int master, int slave) {
  GearAnswer answer{gears, wrong_with(gears, master, slave)};
  if (answer.error != GearError::ok) return answer;
  const auto present = at(gears, slave).master;
  if (is_gear_master(gears, slave))
    answer.error = GearError::is_master;
  else if (is_gear_slave(gears, master) || (present && *present != master))
    answer.error = GearError::bad_link;
  else
    at(answer.gears, slave).master = master;
  return answer;
}

GearAnswer gear_in(const Gears& gears, int master, int slave, double ratio, double master_position,
                   double slave_position) {
  GearAnswer answer{gears, wrong_with(gears, master, slave)};
  if (answer.error != GearError::ok) return answer;
  GearAxis& axis = at(answer.gears, slave);
  if (!axis.master)
    answer.error = GearError::not_enabled;
  else if (*axis.master != master)
    answer.error = GearError::bad_link;
  else if (!std::isfinite(ratio) || ratio == 0)
    answer.error = GearError::bad_ratio;
  if (answer.error != GearError::ok) return answer;
  axis.engaged = true;
  axis.ratio = ratio;
  axis.master_origin = master_position;
  axis.slave_origin = slave_position;
  return answer;
}

GearAnswer gear_out(const Gears& gears, int slave) {
  if (!is_axis(slave)) return {gears, GearError::bad_slave};
  if (!is_gear_slave(gears, slave)) return {gears, GearError::not_enabled};
  GearAnswer answer{gears};
  at(answer.gears, slave).engaged = false;
  return answer;
}

GearAnswer disable_gear(const Gears& gears, int slave) {
  if (!is_axis(slave)) return {gears, GearError::bad_slave};
  if (!is_gear_slave(gears, slave)) return {gears, GearError::not_enabled};
  if (is_in_gear(gears, slave)) return {gears, GearError::synchronized};
  GearAnswer answer{gears};
  GearAxis& axis = at(answer.gears, slave);
  axis = {.enabled = axis.enabled, .in_cam = axis.in_cam};
  return answer;
}

double gear_ratio(const Gears& gears, int slave) {
  return is_axis(slave) ? at(gears, slave).ratio : 0;
}

bool is_in_gear(const Gears& gears, int slave) {
  return is_axis(slave) && at(gears, slave).engaged;
}

bool is_gear_master(const Gears& gears, int axis) {
  return std::any_of(gears.axis.begin(), gears.axis.end(),
                     [&](const GearAxis& each) { return each.master == axis; });
}

bool is_gear_slave(const Gears& gears, int axis) {
  return is_axis(axis) && at(gears, axis).master.has_value();
}

double gear_position(const Gears& gears, int slave, double master_position) {
  if (!is_axis(slave)) return 0;
  const GearAxis& axis = at(gears, slave);
  return axis.slave_origin + axis.ratio * (master_position - axis.master_origin);
}

}  // namespace jounce::himc
