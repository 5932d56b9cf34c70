// SPDX-License-Identifier: Apache-2.0
#include <numbers>
#include <string>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

constexpr double deg = std::numbers::pi / 180;

bool converts(const std::string& from, const std::string& to) {
  try {
    (void)conversion(from, to);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

void read_follower(TomlReader& table, const Units& units, DiscPart& disc) {
  DiscSpec& g = disc.geometry;
  const std::vector<std::string> followers{"translating", "oscillating"};
  if (table.optional_choice("follower", followers) == 1U) g.follower = Follower::oscillating;
  const bool angle = converts(units.position, "rad");
  if (angle && g.follower == Follower::translating)
    throw InputError(
        "units.position", '"' + units.position + '"',
        "must be a length (mm) for a translating follower, or an angle for an oscillating one");
  if (!angle && !converts(units.position, "mm"))
    throw InputError("units.position", '"' + units.position + '"',
                     "must be a length (mm), or the angle of an arm, for a disc cam");
  disc.length = angle ? "mm" : units.position;
  if (g.follower == Follower::translating) {
    g.offset = table.optional_number("offset", disc.length).value_or(0);
    return;
  }
  g.arm_length = table.number("arm_length", disc.length);
  g.center_distance = table.number("center_distance", disc.length);
  if (angle) g.arm_angle = conversion(units.position, "rad");
}

void read_disc_limits(TomlReader& table, DiscPart& disc) {
  auto limits = table.optional_table("limits");
  if (!limits) return;
  if (const auto angle = limits->optional_number("pressure_angle", "deg")) {
    if (!(*angle > 0 && *angle < 90))
      limits->fail("pressure_angle", number(*angle), "must be between 0 and 90 deg");
    disc.limits.pressure_angle = *angle * deg;
  }
  disc.limits.profile_radius = limits->optional_number("profile_radius", disc.length);
  if (disc.limits.profile_radius.value_or(0) < 0)
    limits->fail("profile_radius", number(*disc.limits.profile_radius), "must not be negative");
  limits->finish();
}

}  // namespace

DiscPart read_disc_geometry(TomlReader& table, const Units& units) {
  if (!converts(units.x, "rad"))
    throw InputError("units.master", '"' + units.x + '"',
                     "must be an angle (deg, rad, rev) for a disc cam");
  DiscPart disc;
  disc.geometry.angle = conversion(units.x, "rad");
  read_follower(table, units, disc);
  disc.geometry.roller_radius = table.optional_number("roller_radius", disc.length).value_or(0);
  const std::vector<std::string> rotations{"counterclockwise", "clockwise"};
  if (table.optional_choice("rotation", rotations) == 1U)
    disc.geometry.rotation = Rotation::clockwise;
  return disc;
}

std::optional<DiscPart> read_disc(TomlReader& top, const Units& units) {
  auto table = top.optional_table("disc");
  if (!table) return std::nullopt;
  DiscPart disc = read_disc_geometry(*table, units);
  disc.geometry.base_radius = table->number("base_radius", disc.length);
  disc.limits.cutter_radius = table->optional_number("cutter_radius", disc.length);
  disc.hub_radius = table->optional_number("hub_radius", disc.length);
  disc.tolerance = table->optional_number("tolerance", disc.length)
                       .value_or(1e-3 * conversion("mm", disc.length));
  for (const auto& [key, value] : {std::pair{"tolerance", disc.tolerance},
                                   {"cutter_radius", disc.limits.cutter_radius.value_or(1)},
                                   {"hub_radius", disc.hub_radius.value_or(1)}})
    if (!(value > 0)) table->fail(key, number(value), "must be greater than 0");
  if (disc.hub_radius && disc.geometry.base_radius > 0 &&
      !(*disc.hub_radius < disc.geometry.base_radius))
    table->fail("hub_radius", number(*disc.hub_radius),
                "must be less than base_radius = " + number(disc.geometry.base_radius) + " " +
                    disc.length + ": the hub lies inside the plate");
  read_disc_limits(*table, disc);
  table->finish();
  return disc;
}

}  // namespace jounce::spec_detail
