// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/path/group_limits.hpp"

namespace jounce {

/// The override of a group, and the further limits that its commands set. The limit of an axis is
/// L = override * min(further limit, configured limit), as in the PMC600 (manual 7.2.4).
///
///     GroupDynamics dynamics(group);
///     dynamics.set(command::GroupSetOverride{.acceleration = 0.5});
///     plan(..., dynamics.next());                   // the commands that follow
///     dynamics.rate(program, length);               // the speed of the present motion
///
/// The commands that follow are planned within the lower limits. The present motion keeps its path and
/// its timing law: only its speed is reduced, until all peaks from its last rest to its end are within
/// the lower limits. Queued limits do not reduce its speed. If commands with queued limits continue the
/// present motion, each of them contains its own limits, so an override raises its speed at most to 1.
class GroupDynamics {
 public:
  /// Limits of the commands that follow.
  struct Next {
    ExecutorGroup group;    ///< the group with the shares of the override
    ExecutorGroup limited;  ///< the same, also within the further limits of its axes
    PathLimits path;        ///< further limits along the path
    /// Further limits of the coordinates (none), then of the joints; without kinematics, of the axes
    std::vector<AxisRates> axes;
  };

  explicit GroupDynamics(const ExecutorGroup& group);

  void set(const command::Override& override);
  void set(const command::GroupSetOverride& override);
  /// Throws InputError "axis" for an axis that the group does not have, and "deceleration" for a
  /// deceleration of an axis. `continues`: commands with these queued limits continue the present motion.
  void set(const command::GroupSetLimits& limits, bool continues = false);
  /// Removes the further limits.
  void clear();
  /// A motion from rest begins: queued limits now apply to the present motion. `own_limits`: its commands
  /// contain other limits, which apply instead.
  void begin(bool own_limits = false) {
    present_ = planned_;
    continued_ = own_limits;
    at_once_ = {.axes = std::vector<Limits>(planned_.axes.size())};
  }

  /// True if there are further limits.
  [[nodiscard]] bool limits() const { return limits_; }
  [[nodiscard]] Next next() const;
  /// The factor of the speed, 0 to 2, at which the group plays a program at this length along its path.
  [[nodiscard]] double rate(const GroupProgram& program, double length) const;
  /// The factor of the speed while the group plays no program.
  [[nodiscard]] double rate() const { return override_.velocity; }

 private:
  /// The limits of an axis: override * min(further limit, configured limit).
  [[nodiscard]] Limits effective(const Limits& configured, const Limits& further) const;
  [[nodiscard]] ExecutorGroup limited(bool further) const;
  [[nodiscard]] std::vector<AxisRates> further_rates() const;
  [[nodiscard]] double within(double rate, const ProgramPart& part,
                              const GroupLimits& limits_of) const;

  const ExecutorGroup& group_;
  command::GroupSetOverride override_;
  GroupLimits planned_;     // for the next commands
  GroupLimits present_;     // for the present motion
  bool continued_ = false;  // commands with other limits continue the present motion
  GroupLimits at_once_;     // limits since its beginning that apply to all of it
  bool limits_ = false;
};

}  // namespace jounce
