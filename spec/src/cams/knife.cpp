// SPDX-License-Identifier: Apache-2.0
#include <numbers>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

std::optional<double> factor(const std::string& from, const std::string& to) {
  try {
    return conversion(from, to);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Slave units of one revolution: from the unit if it is an angle; the circumference if it is a
/// length; otherwise `turn`.
double read_turn(TomlReader& knife, const Units& units, double diameter) {
  if (const auto given = knife.optional_number("turn", units.position)) return *given;
  if (const auto angle = factor("rev", units.position)) return *angle;
  if (const auto length = factor(units.x, units.position))
    return std::numbers::pi * diameter * *length;
  knife.fail("turn", "", "is missing: add turn = NUMBER, one revolution in " + units.position);
}

const std::vector<std::string> matchings{"surface", "horizontal"};

}  // namespace

RotaryKnifeSpec read_knife(TomlReader knife, const Units& units) {
  RotaryKnifeSpec spec;
  spec.diameter = knife.number("diameter", units.x);
  spec.blades = knife.optional_count("blades").value_or(1);
  spec.cut_length = knife.number("cut_length", units.x);
  spec.turn = read_turn(knife, units, spec.diameter);
  // An angle of the knife is in degrees if the unit of the slave is not an angle.
  const bool angular = factor("rev", units.position).has_value();
  const double degree = angular ? 1 : spec.turn / 360;
  if (const auto angle = knife.optional_number("sync_angle", angular ? units.position : "deg"))
    spec.sync_angle = *angle * degree;
  spec.sync_length = knife.optional_number("sync_length", units.x);
  spec.thickness = knife.optional_number("thickness", units.x).value_or(0);
  if (const auto matching = knife.optional_choice("matching", matchings))
    spec.matching = static_cast<KnifeMatching>(*matching);
  spec.speed_ratio = knife.optional_number("speed_ratio", "1").value_or(1);
  spec.law = read_law(knife, "law").value_or(spec.law);
  spec.form = read_form(knife);
  spec.dwell = knife.optional_flag("dwell").value_or(false);
  spec.tolerance = knife.optional_number("tolerance", "1").value_or(spec.tolerance);
  knife.finish();
  try {
    (void)figures(spec);
  } catch (const InputError& error) {
    throw InputError(knife.path(error.key()), error.value(), error.rule());
  }
  return spec;
}

}  // namespace jounce::spec_detail
