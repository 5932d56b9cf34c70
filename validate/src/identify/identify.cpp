// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/identify.hpp"

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/fill.hpp"

#include "validate/src/identify/identify_fit.hpp"
#include "validate/src/identify/identify_rules.hpp"

namespace jounce {

const char* name(Identification::Status status) {
  switch (status) {
    case Identification::Status::converged:
      return "converged";
    case Identification::Status::misfit:
      return "misfit";
    case Identification::Status::not_identifiable:
      return "not identifiable";
    case Identification::Status::stalled:
      return "stalled";
    case Identification::Status::cancelled:
      return "cancelled";
    case Identification::Status::failed:
      break;
  }
  return "failed";
}

Trajectory commanded_motion(const Recording& recording) {
  validate_detail::require_times(recording);
  FillSpec spec{.x = recording.time, .p = recording.command};
  spec.filling = Filling::clamped;
  return filled(spec).table.curve<OverTime>();
}

Identification identify(const Recording& recording, const SignalView& reference,
                        const IdentifySpec& spec, const IdentifyProgress& keep_going) {
  validate_detail::require_valid(recording);
  validate_detail::require_valid(spec);
  if (reference.over_master())
    throw InputError("axis", "master", "must be time: a drive follows a motion over time");
  if (recording.time.front() < reference.start())
    throw InputError("time[1]", recording.time.front(),
                     "must not be before the motion's start at " + number(reference.start()));
  return validate_detail::told(recording, spec,
                               validate_detail::fitted(recording, reference, spec, keep_going));
}

}  // namespace jounce
