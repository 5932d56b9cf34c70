// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/axis_drive.hpp"
#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

/// The new names of keys that the first version of format 1 had. The error for an old key names the
/// new one.
constexpr std::array<std::pair<const char*, const char*>, 12> moved{{
    {"motor_inertia", "inertia in [drive.motor]"},
    {"motor_friction", "friction = { viscous = ... } in [drive.motor]"},
    {"torque_limit", "torque_limit in [drive.motor]"},
    {"load_inertia", "inertia in [[drive.mass]]"},
    {"shaft_stiffness", "stiffness in [[drive.mass]]"},
    {"shaft_damping", "damping in [[drive.mass]]"},
    {"load_friction", "friction = { viscous = ... } in [[drive.mass]]"},
    {"position_gain", "position_gain in [drive.controller]"},
    {"velocity_gain", "velocity_gain in [drive.controller]"},
    {"integral_time", "integral_time in [drive.controller]"},
    {"velocity_feed_forward", "velocity_feed_forward in [drive.controller]"},
    {"torque_feed_forward", "torque_feed_forward in [drive.controller]"},
}};

void refuse_moved(TomlReader& table) {
  for (const auto& [key, where] : moved)
    if (table.has(key)) table.fail(key, "", std::string("is now ") + where);
}

/// Reads the numbers whose key begins with `prefix` from the table of their part.
void read_part(TomlReader& table, const std::string& prefix, Drive& drive) {
  const std::string of_friction = "friction.";
  const bool has_friction =
      std::ranges::any_of(numbers(drive), [key = prefix + of_friction](const DriveNumber& number) {
        return number.key.starts_with(key);
      });
  auto friction = has_friction ? table.optional_table("friction") : std::nullopt;
  for (const DriveNumber& number : numbers(drive)) {
    if (!number.key.starts_with(prefix)) continue;
    std::string key = number.key.substr(prefix.size());
    TomlReader* reader = &table;
    if (key.starts_with(of_friction)) {
      if (!friction) continue;
      reader = &*friction;
      key = key.substr(of_friction.size());
    }
    *number.value = reader->optional_number(key.c_str(), number.unit).value_or(*number.value);
  }
  if (friction) friction->finish();
}

/// A linear load at the shaft of the motor: it travels `lever` m per radian.
void read_linear(TomlReader& table, const Units& units, const Drive& drive, Mass& mass) {
  const auto lever = [&](const char* key) {
    try {
      return drive.position_per_rev * conversion(units.position, "m") / (2 * std::numbers::pi);
    } catch (const InputError&) {
      table.fail(
          key, "",
          "applies to a position in a unit of length, not in " + units.position + ": leave it out");
    }
  };
  if (const auto kg = table.optional_number("mass", "kg")) {
    if (table.has("inertia"))
      table.fail("mass", "", "cannot be combined with inertia: give one of the two");
    mass.inertia = *kg * lever("mass") * lever("mass");
  }
  if (const auto newton = table.optional_number("load_force", "N"))
    mass.load_torque += *newton * lever("load_force");
  if (const auto belt = table.optional_number("belt_stiffness", "N/m")) {
    if (table.has("stiffness"))
      table.fail("belt_stiffness", "", "cannot be combined with stiffness: give one of the two");
    const double radius = table.number("pulley_radius", "m");
    mass.stiffness = *belt * radius * radius;
  }
}

void read_train(TomlReader& table, const Units& units, Drive& drive) {
  std::vector<TomlReader> masses = table.tables("mass");
  if (masses.empty()) return;
  drive.train.resize(masses.size());
  for (std::size_t i = 0; i < masses.size(); ++i) {
    read_part(masses[i], "mass[" + std::to_string(i + 1) + "].", drive);
    read_linear(masses[i], units, drive, drive.train[i]);
    masses[i].finish();
  }
}

void read_drive_numbers(TomlReader& table, Drive& drive, const Units& units) {
  drive.position_per_rev = table.number("position_per_rev", units.position + "/rev");
  if (drive.position_per_rev == 0)  // masses need it below
    table.fail("position_per_rev", "0", "must not be 0");
  for (const char* part : {"motor", "controller"})
    if (auto reader = table.optional_table(part)) {
      read_part(*reader, std::string(part) + ".", drive);
      reader->finish();
    }
  read_train(table, units, drive);
  for (const DriveNumber& each : numbers(drive)) table.know(each.key, each.unit);
  if (auto pendulum = table.optional_table("pendulum")) {
    drive.pendulum.emplace();
    read_part(*pendulum, "pendulum.", drive);
    pendulum->finish();
  }
}

DriveLimits read_drive_limits(TomlReader& limits, const Units& units) {
  const std::string& u = units.position;
  DriveLimits found;
  found.torque = limits.optional_number("torque", "N m");
  found.rms_torque = limits.optional_number("rms_torque", "N m");
  found.current = limits.optional_number("current", "A");
  found.velocity = limits.optional_number("velocity", "rad/s");
  found.following_error = limits.optional_number("following_error", u);
  found.end_following_error = limits.optional_number("end_following_error", u);
  found.sync_following_error = limits.optional_number("sync_following_error", u);
  found.residual = limits.optional_number("residual", u);
  found.settling_band = limits.optional_number("settling_band", u);
  found.settling_time = limits.optional_number("settling_time", "s");
  limits.finish();
  return found;
}

std::vector<Interval> read_drive_sync(TomlReader& table) {
  std::vector<Interval> found;
  for (TomlReader& sync : table.tables("sync")) {
    found.push_back({sync.number("from", "s"), sync.number("to", "s")});
    sync.finish();
  }
  return found;
}

struct Model {
  const char* name;
  Drive (*make)();
};
constexpr std::array<Model, 2> models{
    {{"servo_400w", servo_400w}, {"wittenstein_premo_2d", wittenstein_premo_2d}}};

Drive read_model(TomlReader& table) {
  std::vector<std::string> names;
  for (const Model& model : models) names.emplace_back(model.name);
  const auto chosen = table.optional_choice("model", names);
  return chosen ? models[*chosen].make() : Drive{};
}

}  // namespace

DriveSpec read_drive_table(TomlReader& table, const Units& units) {
  refuse_moved(table);
  DriveSpec spec;
  spec.drive = read_model(table);
  read_drive_numbers(table, spec.drive, units);
  spec.settle = table.optional_number("settle", "s").value_or(spec.settle);
  spec.periodic = table.optional_flag("periodic").value_or(false);
  spec.sync = read_drive_sync(table);
  spec.tolerances = read_tolerances(table, spec.drive);
  if (auto limits = table.optional_table("limits")) spec.limits = read_drive_limits(*limits, units);
  table.finish();
  try {
    require_valid(spec.drive);
    require_valid(spec.options(), spec.drive);
  } catch (const InputError& error) {  // the model names its own fields
    throw InputError(table.path(error.key()), error.value(), error.rule());
  }
  return spec;
}

std::optional<DriveSpec> read_drive(TomlReader& owner, const Units& units) {
  auto table = owner.optional_table("drive");
  if (!table) return std::nullopt;
  return read_drive_table(*table, units);
}

}  // namespace jounce::spec_detail
