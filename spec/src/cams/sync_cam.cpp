// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>

#include "jounce/gear/gear.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/in_document.hpp"
#include "jounce/spec/sync_spec.hpp"

#include "spec/src/cams/of_follow.hpp"

namespace jounce {
namespace {

using spec_detail::in_document;
using spec_detail::of_follow;

SyncCam made(const GearSpec& spec) {
  const Gear gear = Gear::ratio(spec.numerator, spec.denominator);
  const double travel = spec.master_period * static_cast<double>(gear.numerator()) /
                        static_cast<double>(gear.denominator());
  return {Cam({line(spec.master_period, 0, travel)}, 0, Extrapolation::advance),
          {"gear"},
          {{0, spec.master_period, "gear"}}};
}

/// The error with the key in the document instead of the generator's field. The clutch of
/// `distance` is the first change of the course.
InputError of_course(const InputError& error) {
  std::string key = error.key();
  for (const auto& [ours, theirs] : {std::pair{"change[1].at", "engage_at"},
                                     {"change[1].distance", "distance"},
                                     {"change[1].law", "law"},
                                     {"change[1].ratio", "numerator"}})
    if (key == ours) key = theirs;
  if (key.starts_with("change[")) {
    const auto end = key.find(']');
    key = "change[" + std::to_string(std::stoi(key.substr(7, end - 7)) - 1) + key.substr(end);
  }
  return {"gear." + key, error.value(), error.rule()};
}

/// The error of an engagement in which the slave must reverse, with the change that avoids it.
InputError must_reverse(const GearInPosSpec& spec, GearInPosStatus status) {
  const EngageWindow window = engage_window(spec);
  const bool forward = spec.numerator > 0;  // the denominator is
  const std::string remedy =
      window.exists ? "use master_start_distance from " + six_digits_up(window.least) + " to " +
                          six_digits_down(window.greatest)
                    : std::string("slave_start must be ") + (forward ? "below" : "above") +
                          " slave_sync_position = " + number(spec.slave_sync_position);
  return {"master_start_distance", spec.master_start_distance,
          std::string("makes the slave reverse") +
              (spec.slave_period ? ", even with five more turns" : "") + ": " + remedy +
              ", or set avoid_reversal = false (error " + std::to_string(static_cast<int>(status)) +
              " of the PMC600)"};
}

SyncCam made(const GearCourse& spec) {
  try {
    return gear_course(spec);
  } catch (const InputError& error) {
    throw of_course(error);
  }
}

SyncCam made(const GearInPosPart& spec) {
  try {
    const GearInPos gear = gear_in_pos(spec.gear);
    if (!gear) throw must_reverse(spec.gear, gear.status);
    return sync_cam(gear, spec.master_start, spec.master_end);
  } catch (const InputError& error) {
    throw InputError("gear." + error.key(), error.value(), error.rule());
  }
}

SyncCam made(const FollowPart& spec) {
  return of_follow(spec, [](const auto& slave) { return follow(slave); });
}

SyncCam made(const RotaryKnifeSpec& spec) {
  return in_document("knife.", [&] { return rotary_knife(spec); });
}

SyncCam made(const FlyingShear& spec) {
  return in_document("shear.", [&] { return flying_shear(spec); });
}

SyncCam made(const CutListSpec& spec) {
  const bool shear = std::holds_alternative<FlyingShear>(spec.machine);
  return in_document(shear ? "shear." : "knife.", [&] { return cut_list(spec); });
}

SyncCam made(const Indexer& spec) {
  return in_document("indexer.", [&] { return indexer(spec); });
}

}  // namespace

std::optional<CutListSpec> cut_list_of(const SyncSpec& spec) {
  if (const auto* list = std::get_if<CutListSpec>(&spec)) return *list;
  if (const auto* knife = std::get_if<RotaryKnifeSpec>(&spec))
    return CutListSpec{*knife, {.lengths = {knife->cut_length}}};
  if (const auto* shear = std::get_if<FlyingShear>(&spec))
    return CutListSpec{*shear, {.lengths = {shear->cut_length}}};
  return std::nullopt;
}

SyncCam sync_cam_of(const SyncSpec& spec) {
  return std::visit([](const auto& each) { return made(each); }, spec);
}

}  // namespace jounce
