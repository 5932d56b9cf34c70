#include "jounce/io/detail/sync_gear.hpp"

#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce::detail {
namespace {

/// A generator names its own fields; the clutch of `distance` is the course's first change.
InputError in_document(const InputError& error) {
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

/// What to change where GearInPos answers that it cannot be had.
std::string rule_of(const GearInPos& gear, const GearInPosSpec& spec) {
  const std::string code = " (PMC600 error " + std::to_string(static_cast<int>(gear.status)) + ")";
  const EngageWindow window = engage_window(spec);
  return std::string(explain(gear.status)) + code +
         (window.advice.empty() ? "" : "; " + window.advice);
}

}  // namespace

SyncCam made_gear(const GearCourse& spec) {
  try {
    return gear_course(spec);
  } catch (const InputError& error) {
    throw in_document(error);
  }
}

SyncCam made_gear(const GearInPosPart& spec) {
  try {
    const GearInPos gear = gear_in_pos(spec.gear);
    if (!gear) throw InputError("avoid_reversal", "true", rule_of(gear, spec.gear));
    return sync_cam(gear, spec.master_start, spec.master_end);
  } catch (const InputError& error) {
    throw InputError("gear." + error.key(), error.value(), error.rule());
  }
}

}  // namespace jounce::detail
