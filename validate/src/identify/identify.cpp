// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/identify.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/fill.hpp"

#include "validate/src/identify/identify_fit.hpp"
#include "validate/src/identify/identify_rules.hpp"
#include "validate/src/identify/setpoint_curve.hpp"

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

namespace {

/// The cubic spline through the commands, with continuous acceleration, at rest at both ends.
Trajectory spline_through(std::vector<double> times, std::vector<double> commands) {
  FillSpec spec{.x = std::move(times), .p = std::move(commands)};
  spec.filling = Filling::clamped;
  return filled(spec).table.curve<OverTime>();
}

/// The spline through every second command, and the last one.
Trajectory coarse_motion(const Recording& recording) {
  std::vector<double> times, commands;
  const auto add = [&](std::size_t i) {
    times.push_back(recording.time[i]);
    commands.push_back(recording.command[i]);
  };
  const std::size_t n = recording.time.size();
  for (std::size_t i = 0; i < n; i += 2) add(i);
  if (n % 2 == 0) add(n - 1);
  return spline_through(std::move(times), std::move(commands));
}

/// True if the feed-forward of the recorded controller can be fitted. That of the spec refers to an
/// inertia that is only a start. The torque shows the inertia, and the motion shows the feed-forward.
bool frees_feed_forward(const Recording& recording, const IdentifySpec& spec) {
  const bool has_motion =
      !recording.position.empty() || !recording.velocity.empty() || !recording.load.empty();
  return has_motion && !recording.torque.empty() && spec.drive.controller.torque_feed_forward > 0 &&
         std::any_of(spec.fit.begin(), spec.fit.end(),
                     [](const std::string& key) { return key.ends_with("inertia"); });
}

bool is_determined(Identification::Status status) {
  return status == Identification::Status::converged || status == Identification::Status::misfit ||
         status == Identification::Status::cancelled;
}

Identification found(const Recording& recording, const validate_detail::Commanded& command,
                     const IdentifySpec& spec, const IdentifyProgress& keep_going) {
  const auto with = [&](const std::vector<std::string>& keys) {
    return validate_detail::told(
        recording, spec, validate_detail::fitted(recording, command, spec, keys, keep_going));
  };
  if (frees_feed_forward(recording, spec)) {
    std::vector<std::string> keys = spec.fit;
    keys.emplace_back(validate_detail::controller_share);
    Identification free = with(keys);
    if (is_determined(free.status)) return free;
  }
  return with(spec.fit);
}

constexpr std::size_t least_samples_of_coarse = 8;  ///< a spline needs four commands

}  // namespace

Identification identify(const Recording& recording, const IdentifySpec& spec,
                        const IdentifyProgress& keep_going) {
  validate_detail::require_valid(recording);
  validate_detail::require_valid(spec);
  if (!recording.setpoints.empty()) {
    const validate_detail::SetpointCurve command(recording.setpoints);
    return found(recording, {command, &command}, spec, keep_going);
  }
  const Trajectory command = spline_through(recording.time, recording.command);
  std::optional<Trajectory> coarse;
  if (recording.time.size() >= least_samples_of_coarse) coarse = coarse_motion(recording);
  return found(recording, {command, nullptr, coarse ? &*coarse : nullptr}, spec, keep_going);
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
  return found(recording, {reference}, spec, keep_going);
}

}  // namespace jounce
