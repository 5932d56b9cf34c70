// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/axis/group_program.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/path/group_limits.hpp"

namespace jounce {

/// The override of a group, and the further limits that its commands set. The limit of an axis is
/// L = override * min(further limit, configured limit), as in the PMC600 (manual 7.2.4).
///
///     GroupDynamics dynamics(group);
///     dynamics.set(command::GroupSetOverride{.acceleration = 0.5});
///     plan(..., dynamics.limited());                // the next motion from rest
///     dynamics.rate(part_at(program, length));      // the speed of the present motion
///
/// The next motion from rest is planned within the lower limits. The present motion keeps its path
/// and its timing law: only its speed is reduced, until all peaks from its last rest to its end are
/// within the lower limits.
class GroupDynamics {
 public:
  explicit GroupDynamics(const ExecutorGroup& group);

  void set(const command::Override& override);
  void set(const command::GroupSetOverride& override);
  /// Throws InputError "axis" for an axis that the group does not have, and "deceleration" for a
  /// deceleration of an axis.
  void set(const command::GroupSetLimits& limits);
  /// Removes the further limits.
  void clear();
  /// A motion from rest begins: queued limits now apply to the present motion.
  void begin() { present_ = planned_; }

  /// True if there are further limits.
  [[nodiscard]] bool limits() const { return limits_; }
  /// Further limits along the path for the next commands.
  [[nodiscard]] const PathLimits& path() const { return planned_.path; }
  /// The group with the limits of its axes for the next motion from rest.
  [[nodiscard]] ExecutorGroup limited() const;
  /// The factor of the speed, 0 to 2, at which the group plays a part of a program.
  [[nodiscard]] double rate(const ProgramPart& part) const;
  /// The factor of the speed while the group plays no program.
  [[nodiscard]] double rate() const { return override_.velocity; }

 private:
  /// The limits of an axis: override * min(further limit, configured limit).
  [[nodiscard]] Limits effective(const Limits& configured, const Limits& further) const;

  const ExecutorGroup& group_;
  command::GroupSetOverride override_;
  GroupLimits planned_;  // for the next commands
  GroupLimits present_;  // for the present motion
  bool limits_ = false;
};

}  // namespace jounce
