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

CutList checked(CutList list, const Cutter& cutter) {
  require_valid(list, cutter);
  return list;
}

}  // namespace

std::optional<CutList> read_cut_list(TomlReader& cutter, const std::string& master) {
  CutList list;
  if (cutter.has("lengths")) list.lengths = cutter.number_list("lengths", master);
  if (cutter.has("lengths") && list.lengths.empty())
    cutter.fail("lengths", "[]", "must have at least one length");
  if (cutter.has("lengths") && cutter.has("cut_length"))
    cutter.fail("lengths", "", "cannot be combined with cut_length: give one of the two");
  list.first = cutter.optional_positive("first", master);
  list.waste = cutter.optional_positive("waste", master);
  if (list.lengths.empty() && !list.first && !list.waste) return std::nullopt;
  if (list.lengths.empty()) list.lengths = {cutter.number("cut_length", master)};
  return list;
}

SyncSpec with_list(CutMachine machine, std::optional<CutList> list) {
  if (list) return CutListSpec{std::move(machine), std::move(*list)};
  return std::visit([](auto& only) -> SyncSpec { return std::move(only); }, machine);
}

SyncSpec read_knife(TomlReader knife, const Units& units) {
  RotaryKnifeSpec spec;
  spec.diameter = knife.number("diameter", units.x);
  spec.blades = knife.optional_count("blades").value_or(1);
  auto list = read_cut_list(knife, units.x);
  spec.cut_length = list ? list->lengths.front() : knife.number("cut_length", units.x);
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
    if (list) return with_list(spec, checked(*list, Cutter(spec)));
    (void)figures(spec);
  } catch (const InputError& error) {
    throw InputError(knife.path(error.key()), error.value(), error.rule());
  }
  return spec;
}

}  // namespace jounce::spec_detail
