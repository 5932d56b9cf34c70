#include <string>
#include <vector>

#include "jounce/io/detail/spec_parts.hpp"

namespace jounce::detail {
namespace {

void read_drive_numbers(TomlReader& table, Drive& drive, const Units& units) {
  const std::string damping = "N m s/rad";
  const auto read = [&](const char* key, const std::string& unit, double& value) {
    value = table.optional_number(key, unit).value_or(value);
  };
  read("motor_inertia", "kg m^2", drive.motor_inertia);
  read("load_inertia", "kg m^2", drive.load_inertia);
  read("shaft_stiffness", "N m/rad", drive.shaft_stiffness);
  read("shaft_damping", damping, drive.shaft_damping);
  read("motor_friction", damping, drive.motor_friction);
  read("load_friction", damping, drive.load_friction);
  read("position_gain", "1/s", drive.position_gain);
  read("velocity_gain", damping, drive.velocity_gain);
  read("integral_time", "s", drive.integral_time);
  read("velocity_feed_forward", "1", drive.velocity_feed_forward);
  read("torque_feed_forward", "1", drive.torque_feed_forward);
  read("torque_limit", "N m", drive.torque_limit);
  drive.position_per_rev = table.number("position_per_rev", units.position + "/rev");
}

}  // namespace

std::optional<DriveSpec> read_drive(TomlReader& owner, const Units& units) {
  auto table = owner.optional_table("drive");
  if (!table) return std::nullopt;
  DriveSpec spec;
  const std::vector<std::string> models{"servo_400w"};
  if (table->has("model") && table->choice("model", models) == 0) spec.drive = servo_400w();
  read_drive_numbers(*table, spec.drive, units);
  spec.settle = table->optional_number("settle", "s").value_or(spec.settle);
  if (auto limits = table->optional_table("limits")) {
    spec.limits.torque = limits->optional_number("torque", "N m");
    spec.limits.rms_torque = limits->optional_number("rms_torque", "N m");
    spec.limits.following_error = limits->optional_number("following_error", units.position);
    spec.limits.residual = limits->optional_number("residual", units.position);
    limits->finish();
  }
  table->finish();
  try {
    require_valid(spec.drive);
  } catch (const InputError& error) {  // the model names its own fields
    throw InputError(owner.path("drive." + error.key()), error.value(), error.rule());
  }
  return spec;
}

}  // namespace jounce::detail
