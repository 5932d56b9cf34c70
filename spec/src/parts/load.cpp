// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <utility>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce {
namespace {

bool measures(const std::string& unit, const char* as) {
  try {
    (void)conversion(unit, as);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Meters or radians in one slave unit; 0 for a unit that is neither, such as a pulse.
double si(const std::string& unit) {
  if (measures(unit, "m")) return conversion(unit, "m");
  return measures(unit, "rad") ? conversion(unit, "rad") : 0;
}

/// Radians of the motor per slave unit.
double turned(const LoadSpec& load) {
  return 2 * std::numbers::pi / load.position_per_rev;
}

}  // namespace

LinearQuantity torque_of(const LoadSpec& load, double speed, const std::string& unit) {
  const double turn = turned(load);
  const double r = si(unit) / turn;
  LinearQuantity torque{"torque", {}, 0};  // (1) of shape_spec.hpp
  torque.by[0] = r * load.stiffness * si(unit);
  torque.by[1] = load.damping * turn * speed;
  torque.by[2] = (load.inertia + load.mass * r * r) * turn * speed * speed;
  torque.constant = load.torque + r * (load.preload + load.force + load.mass * load.gravity);
  return torque;
}

LinearQuantity motor_speed_of(const LoadSpec& load, double speed) {
  LinearQuantity velocity{"motor speed", {}, 0};
  velocity.by[1] = turned(load) * speed;
  return velocity;
}

bool is_linear(const LoadSpec& load) {
  return load.coulomb == 0 && load.lever == 0;
}

LoadTorque load_torque_of(const LoadSpec& load, double speed, const std::string& unit) {
  const double r = si(unit) / turned(load);
  LoadTorque torque;
  torque.linear = torque_of(load, speed, unit);
  torque.gravity = r * load.lever;
  torque.turn = si(unit);
  torque.angle = load.lever_angle;
  torque.coulomb = load.coulomb;
  if (turned(load) > 0) return torque;
  for (double& by : torque.linear.by) by = -by;  // the motor turns the other way
  torque.linear.constant = -torque.linear.constant;
  torque.gravity = -torque.gravity;
  return torque;
}

EnergyOf energy_of(const LoadSpec& load, double speed, const std::string& unit) {
  EnergyOf energy{load_torque_of(load, speed, unit), load.recovered};
  const double turn = std::abs(turned(load));  // integral of T theta' = integral of T turn f'
  for (double& by : energy.load.linear.by) by *= turn;
  energy.load.linear.constant *= turn;
  energy.load.coulomb *= turn;
  energy.load.gravity *= turn;
  return energy;
}

namespace spec_detail {
namespace {

struct LoadKey {
  const char* key;
  const char* unit;         ///< for a linear slave, or for any slave
  const char* rotary_unit;  ///< nullptr: linear only; "": any; `unit` nullptr: rotary only
  double LoadSpec::*field;
  bool may_be_negative;
};

const std::vector<LoadKey> keys{
    {"inertia", "kg m^2", "", &LoadSpec::inertia, false},
    {"damping", "N m s/rad", "", &LoadSpec::damping, false},
    {"torque", "N m", "", &LoadSpec::torque, true},
    {"mass", "kg", nullptr, &LoadSpec::mass, false},
    {"gravity", "m/s^2", nullptr, &LoadSpec::gravity, true},
    {"stiffness", "N/m", "N m/rad", &LoadSpec::stiffness, false},
    {"preload", "N", "N m", &LoadSpec::preload, true},
    {"force", "N", "N m", &LoadSpec::force, true},
    {"coulomb", "N m", "", &LoadSpec::coulomb, false},
    {"lever", nullptr, "N m", &LoadSpec::lever, true},
    {"lever_angle", nullptr, "rad", &LoadSpec::lever_angle, true},
    {"recovered", "1", "", &LoadSpec::recovered, false},
};

std::string instead_of(const LoadKey& key) {
  if (key.unit == nullptr) return ": an arm needs a unit of angle";
  return std::string(": give it at the motor, as ") +
         (key.field == &LoadSpec::mass ? "inertia" : "torque");
}

void read_key(TomlReader& table, const LoadKey& key, const std::string& slave, LoadSpec& load) {
  if (!table.has(key.key)) return;
  const bool any = key.rotary_unit != nullptr && key.rotary_unit[0] == '\0';
  const bool straight = measures(slave, "m") && key.unit != nullptr;
  const bool rotary = measures(slave, "rad") && key.rotary_unit != nullptr;
  if (!any && !straight && !rotary)
    table.fail(key.key, "", "does not fit a slave in " + slave + instead_of(key));
  const double value = table.number(key.key, any || straight ? key.unit : key.rotary_unit);
  if (value < 0 && !key.may_be_negative) table.fail(key.key, number(value), "must not be negative");
  load.*key.field = value;
}

void read_load_limits(TomlReader& reader, LoadSpec& load) {
  auto table = reader.optional_table("limits");
  if (!table) return;
  load.peak_torque = table->optional_positive("torque", "N m");
  load.rms_torque = table->optional_positive("rms_torque", "N m");
  table->finish();
}

}  // namespace

std::optional<LoadSpec> read_load(TomlReader& top, const Units& units) {
  auto table = top.optional_table("load");
  if (!table) return std::nullopt;
  LoadSpec load;
  load.position_per_rev = table->number("position_per_rev", units.position + "/rev");
  if (load.position_per_rev == 0) table->fail("position_per_rev", "0", "must not be 0");
  for (const LoadKey& key : keys) read_key(*table, key, units.position, load);
  if (load.recovered > 1) table->fail("recovered", number(load.recovered), "must be 0 to 1");
  load.winding_loss = table->optional_number("winding_loss", "W/(N m)^2");
  if (load.winding_loss && !(*load.winding_loss > 0))
    table->fail("winding_loss", number(*load.winding_loss), "must be greater than 0");
  read_load_limits(*table, load);
  table->finish();
  return load;
}

}  // namespace spec_detail
}  // namespace jounce
