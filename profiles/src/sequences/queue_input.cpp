// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/sequences/queue_input.hpp"

#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

#include "profiles/src/curve/magnitude.hpp"

namespace jounce::profiles_detail {
namespace {

void require_time(const std::string& key, double value) {
  require_not_negative(key.c_str(), value);
  require_moderate(key, value);
}

void require_valid(const std::string& key, const MotionCommand& command) {
  if (const auto* absolute = std::get_if<MoveAbsolute>(&command))
    require_moderate(key + "position", absolute->position);
  if (const auto* relative = std::get_if<MoveRelative>(&command))
    require_moderate(key + "distance", relative->distance);
  if (const auto* dwell = std::get_if<Dwell>(&command)) require_time(key + "time", dwell->time);
  if (const auto* move = std::get_if<MoveVelocity>(&command))
    if (move->direction != 1 && move->direction != -1)
      throw InputError(key + "direction", move->direction, "must be 1 or -1");
}

void require_valid(const std::string& key, const Dynamics& dynamics, bool halts) {
  if (!halts) require_limit(key + "velocity", dynamics.velocity);
  require_limit(key + "acceleration", dynamics.acceleration);
  if (dynamics.deceleration != 0) require_limit(key + "deceleration", dynamics.deceleration);
  if (dynamics.jerk != 0) require_limit(key + "jerk", dynamics.jerk);
  if (dynamics.deceleration_jerk != 0 && dynamics.deceleration_jerk != dynamics.jerk)
    throw InputError(key + "deceleration_jerk", dynamics.deceleration_jerk,
                     "must be left out or equal to the jerk: a queue is planned with one jerk");
}

/// Returns the time at which the last abort up to this command was issued.
double require_valid_issue(const std::string& key, const QueuedCommand& c, bool first,
                           double before) {
  const bool aborting = c.mode == BufferMode::aborting;
  if (aborting && !first && !c.issued)
    throw InputError(key + "issued", "",
                     "is missing: an aborting command needs the time at which it is issued");
  if (!c.issued) return before;
  require_time(key + "issued", *c.issued);
  if (!aborting)
    throw InputError(key + "issued", *c.issued,
                     "applies to mode = \"aborting\" only, because other commands wait for the "
                     "previous one: leave it out");
  if (*c.issued < before)
    throw InputError(key + "issued", *c.issued,
                     "must not be before " + number(before) + ", the time of the previous abort");
  return *c.issued;
}

void require_valid_dwell(const std::string& key, const QueueSpec& spec, std::size_t i) {
  if (i > 0 && spec.commands[i].mode == BufferMode::aborting)
    throw InputError(key + "mode", "aborting",
                     "does not apply to a dwell: abort with a motion, or leave mode out");
  if (i == 0 && spec.start.acceleration != 0)
    throw InputError("start.acceleration", spec.start.acceleration,
                     "must be 0 where the first command is a dwell: the axis cannot keep it");
}

}  // namespace

void require_valid(const QueueSpec& spec) {
  require_moderate("start.position", spec.start.position);
  require_moderate("start.velocity", spec.start.velocity);
  require_moderate("start.acceleration", spec.start.acceleration);
  if (spec.commands.empty())
    throw InputError("commands", "", "are missing: a queue needs at least one command");
  double issued = 0;
  for (std::size_t i = 0; i < spec.commands.size(); ++i) {
    const QueuedCommand& c = spec.commands[i];
    const std::string key = "commands[" + std::to_string(i + 1) + "].";
    require_valid(key, c.command);
    if (std::holds_alternative<Dwell>(c.command))
      require_valid_dwell(key, spec, i);
    else
      require_valid(key, c.dynamics, std::holds_alternative<Halt>(c.command));
    issued = require_valid_issue(key, c, i == 0, issued);
  }
}

}  // namespace jounce::profiles_detail
