// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/message_catalog.hpp"

#include <array>
#include <string>
#include <string_view>

#include "jounce/command/detail/causes.hpp"
#include "jounce/controllers/controller_errors.hpp"
#include "jounce/report/rules.hpp"
#include "jounce/stream/detail/refusals.hpp"

namespace jounce {
namespace {

/// The group of a Cause. Each group has a block of numbers.
const char* group_of(Cause cause) {
  if (is_fault(cause)) return "Faults of an axis";
  if ((cause >= Cause::stopped && cause <= Cause::group_stopped) ||
      (cause >= Cause::range_end && cause <= Cause::no_acknowledge))
    return "Why a motion ended";
  if (cause >= Cause::bad_table && cause <= Cause::not_in_sync)
    return "Tables that an axis rejects";
  return "Commands that an axis rejects";
}

/// An error of HIMC that a message of Jounce names; aa is the axis.
struct HimcError {
  const char* code;
  const char* meaning;
  const char* remedy;
};

constexpr std::array himc_errors{
    HimcError{"0x83aa006e", "not allowed while enabled", "Disable the axis first: see `enabled`."},
    HimcError{"0x83aa00c8", "input shaping is active",
              "Keep one of the two input shapers of the spec."},
    HimcError{"0x83aa00d2", "compensation is active",
              "Switch the compensation off first: see `compensation_active`."},
    HimcError{"0x83aa0190", "compensation is not configured",
              "Add [compensation] to the spec of the axis: see `no_compensation`."},
    HimcError{"0x83aa0474", "damping of a filter is out of range",
              "Give a damping in the range that the message states."},
    HimcError{"0x83aa047e", "frequency of a filter is out of range",
              "Give a frequency in the range that the message states."},
    HimcError{"0x83aa0802", "compensation is above its maximum",
              "Correct the value of the compensation table, or raise `most`."},
    HimcError{"0x83aa08a2", "PVT velocity is over its limit",
              "Give the points more time, or correct their velocities."},
    HimcError{"0x83aa08ac", "PVT acceleration is over its limit",
              "Give the points more time, or correct their velocities."},
    HimcError{"0x83aa08b6", "PVT time sequence is invalid",
              "Begin the times of the table at 0, and let each be greater than the one before."}};

/// The name by which messages refer to a status: "window_missed" for "CouplingStatus window_missed".
std::string status_name(const ControllerError& error) {
  constexpr std::array kinds{std::string_view("CouplingStatus "),
                             std::string_view("GearInPosStatus ")};
  const std::string_view here = error.here;
  for (const std::string_view kind : kinds)
    if (here.starts_with(kind)) return std::string(here.substr(kind.size()));
  return "";
}

}  // namespace

std::vector<Message> all_messages() {
  std::vector<Message> all;
  for (const CauseInfo& one : all_causes())
    if (one.cause != Cause::none)
      all.push_back({group_of(one.cause), std::to_string(static_cast<int>(one.cause)), one.name,
                     one.meaning, one.remedy});
  for (const wire::RefusalInfo& one : wire::all_refusals())
    if (one.refusal != wire::Refusal::none)
      all.push_back({"Rejections of the stream", std::to_string(static_cast<int>(one.refusal)),
                     one.name, one.meaning, one.remedy});
  for (const RuleInfo& one : all_rules())
    all.push_back({"Findings of a check", "", one.rule, one.meaning, one.remedy});
  for (const ControllerError& one : controller_errors()) {
    const std::string here = one.here == std::string("none") ? "does not occur" : one.here;
    all.push_back({std::string("Errors of ") + one.controller + " for cams and gears",
                   code_text(one), status_name(one), one.meaning, here + ": " + one.how, true});
  }
  for (const HimcError& one : himc_errors)
    all.push_back({"Errors of HIMC that messages of Jounce name (aa: the axis)", one.code, "",
                   one.meaning, one.remedy});
  return all;
}

}  // namespace jounce
