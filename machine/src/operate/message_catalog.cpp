// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/message_catalog.hpp"

#include <string>

#include "jounce/command/causes.hpp"
#include "jounce/controllers/controller_errors.hpp"
#include "jounce/report/rules.hpp"
#include "jounce/stream/message/refusals.hpp"

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

}  // namespace

std::vector<Message> all_messages() {
  std::vector<Message> all;
  for (const CauseInfo& one : all_causes())
    if (one.cause != Cause::none)
      all.push_back({group_of(one.cause), std::to_string(static_cast<int>(one.cause)), one.name,
                     one.meaning, one.remedy});
  for (const wire::RefusalInfo& one : wire::all_refusals())
    if (one.refusal != wire::Refusal::none)
      all.push_back({"Refusals of the stream", std::to_string(static_cast<int>(one.refusal)),
                     one.name, one.meaning, one.remedy});
  for (const RuleInfo& one : all_rules())
    all.push_back({"Findings of a check", "", one.rule, one.meaning, one.remedy});
  for (const ControllerError& one : controller_errors()) {
    const std::string here = one.here == std::string("none") ? "does not occur" : one.here;
    all.push_back({std::string("Errors of ") + one.controller + " for cams and gears",
                   code_text(one), "", one.meaning, here + ": " + one.how, true});
  }
  return all;
}

}  // namespace jounce
