// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/path/arc.hpp"
#include "jounce/path/axis_map.hpp"
#include "jounce/path/frame.hpp"
#include "jounce/path/group_limits.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/path/point.hpp"
#include "jounce/path/program.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// The coordinates that the commands of a group can reach.
struct GroupSpace {
  std::vector<Limits> limits = {};  ///< limits and ranges of the coordinates
  PathLimits path = {};             ///< along the path
  /// From the coordinates to the joints; null: the coordinates are the axes.
  std::shared_ptr<const AxisMap> map = {};
  std::vector<Limits> joints = {};  ///< limits and ranges of the joints
};

/// The place where a jog ends if no command ends it.
struct JogEnd {
  /// range_end, reach_end or singular_end; none: after an hour at full speed.
  Cause cause = Cause::none;
  bool of_joint = false;  ///< true: `index` counts the joints, false: the coordinates
  std::size_t index = 0;  ///< the axis that determines the end
  double limit = 0;       ///< for range_end: end of the position range of this axis
  Point place{};          ///< coordinates of the end
};

/// A jog that cannot begin, because an axis stands at the end of its range or the group at the end
/// of its reach.
struct JogLeadsOutward : InputError {
  explicit JogLeadsOutward(const JogEnd& where)
      : InputError("the jog", "",
                   "leads outward: the group stands at the end of its reach: jog in another "
                   "direction"),
        end(where) {}
  JogEnd end;  ///< the end at which the group stands
};

/// A commanded velocity along the path above its limit.
struct LoweredVelocity {
  double commanded = 0;     ///< u/s
  double permitted = 0;     ///< u/s: the highest velocity that the limits permit
  bool everywhere = false;  ///< true: `permitted` applies on all of the command
};

/// Commands of a group in their order, as a program for the planner. Each command has a number,
/// which is the source line of its pieces in the plan.
///
///     PathCommands commands(2, {0, 0});
///     commands.append(command::MoveLinearAbsolute{.to = {10, 5}});
///     const Plan motion = plan(commands.program(), limits);
///
/// Units are those of the axes. The axes after the path axes are followers: they move in proportion
/// to the length, and have no value in an arc but its end. A command that moves only followers has
/// the length of their motion.
class PathCommands {
 public:
  /// `axes`: 1 to max_axes. `start`: where the first command begins. `first`: its number.
  /// `path_axes`: number of path axes (Program); 0: all axes.
  PathCommands(std::size_t axes, const Point& start, std::int32_t first = 1,
               std::size_t path_axes = 0);

  /// Sets the turns of rotary followers, u; 0 or beyond the last entry: a linear axis. An absolute
  /// position of a rotary follower is reached on the shortest way.
  void set_modulo(std::vector<double> modulo) { modulo_ = std::move(modulo); }
  /// Sets the frame of the commands that are appended from now on.
  void set_frame(const Frame& frame) { frame_ = frame; }
  /// Sets further limits for the commands that are appended from now on: along the path, and of the
  /// axes (PathSettings::axes).
  void set_limits(const PathLimits& limits, std::vector<AxisRates> axes = {}) {
    limits_vary_ = limits_vary_ || (!all_.empty() && !has_limits(limits, axes));
    limits_ = limits;
    axis_limits_ = std::move(axes);
  }
  /// True if every command was appended with exactly these limits (set_limits()).
  [[nodiscard]] bool has_limits(const PathLimits& limits, std::span<const AxisRates> axes) const {
    return !limits_vary_ && limits == limits_ && std::ranges::equal(axes, axis_limits_);
  }

  /// Appends a command. Throws InputError with the name of the field for a command without a
  /// coordinate or of no length, for a coordinate beyond the axes, and for an arc that does not
  /// fit.
  void append(const command::GroupWait& wait);
  template <bool relative>
  void append(const command::MoveLinear<relative>& line);
  template <bool relative>
  void append(const command::MoveDirect<relative>& line);
  template <bool relative>
  void append(const command::MoveCircular<relative>& arc);
  /// A jog ends at the last place on its line that the group can reach: see jog_end(). Throws
  /// JogLeadsOutward if the group stands there.
  void append(const command::GroupJog& jog, const GroupSpace& space);
  /// Appends a command of a client. Throws InputError also for a command that is not a command of a
  /// group.
  void append(const ClientCommand& command, const GroupSpace& space);

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  /// True if a command moves.
  [[nodiscard]] bool moves() const;
  /// Number of the first command, and of the last one.
  [[nodiscard]] std::int32_t first() const { return first_; }
  [[nodiscard]] std::int32_t last() const {
    return first_ + static_cast<std::int32_t>(all_.size()) - 1;
  }
  /// End of the last command.
  [[nodiscard]] const Point& position() const { return all_.empty() ? start_ : all_.back().to; }
  /// End of the last jog; nullopt: there was none.
  [[nodiscard]] const std::optional<JogEnd>& jog_end() const { return jog_end_; }

  /// The velocity of the last command if it exceeds the limits of the path and of the coordinates;
  /// nullopt: it exceeds no limit, or the command has no velocity. The limits of joints are not
  /// considered.
  [[nodiscard]] std::optional<LoweredVelocity> lowered_velocity(const GroupSpace& space) const;

  /// The index of the first follower that the last command moves; nullopt: the command moves a path
  /// axis, or no axis.
  [[nodiscard]] std::optional<std::size_t> moves_only_follower() const;
  /// The velocity of the last command, u/s; PathSettings::none: none was given.
  [[nodiscard]] double commanded_velocity() const {
    return all_.empty() ? PathSettings::none : all_.back().commanded;
  }

  /// The commands as a program.
  [[nodiscard]] Program program() const;
  /// The same commands, but the last one that moves begins at rest.
  [[nodiscard]] PathCommands stopping() const;
  /// The same commands, each at most as fast as in `plan`. Commands that are appended later then
  /// continue at the velocity of the plan; the group does not accelerate first.
  [[nodiscard]] PathCommands slowed(const Plan& plan) const;
  /// The commands from this number on.
  [[nodiscard]] PathCommands from(std::int32_t number) const;
  /// Returns the number of the command at the distance `u` from the start of a piece of the plan. A
  /// piece may have several commands, because the planner joins lines in the same direction;
  /// `number` is the number of the first one.
  [[nodiscard]] std::int32_t number_at(std::int32_t number, double u) const;

 private:
  struct Line {};
  struct Wait {
    double duration = 0;
  };
  struct One {
    PathSettings settings = {};
    std::variant<Line, Arc, Wait> what = {};
    Point to = {};
    double commanded = PathSettings::none;  // velocity of the command, u/s
  };
  [[nodiscard]] bool framed() const { return frame_ != Frame{}; }
  /// End of the last command in the frame.
  [[nodiscard]] Point part() const;
  [[nodiscard]] Point machine(const Point& part) const;
  /// The end of a command, without the rounding of the frame in axes that do not move.
  [[nodiscard]] Point machine_end(const Point& part) const;
  [[nodiscard]] std::size_t measured() const { return path_axes_ == 0 ? axes_ : path_axes_; }
  [[nodiscard]] double length(const Point& from, const Point& to) const;
  [[nodiscard]] const Point& from_of_last() const;
  [[nodiscard]] bool is_at(const Point& part) const;
  [[nodiscard]] Point target(const command::Coordinates& to, bool relative) const;
  void add_line(const command::Coordinates& to, bool relative, const PathSettings& settings);
  [[nodiscard]] PathSettings within_limits(PathSettings settings) const;

  std::size_t axes_, path_axes_;
  std::vector<double> modulo_;
  Frame frame_;
  PathLimits limits_;
  std::vector<AxisRates> axis_limits_;
  bool limits_vary_ = false;
  Point start_;
  std::int32_t first_;
  std::deque<One> all_;
  std::optional<JogEnd> jog_end_;
};

/// Returns the frame of a command for a group with this number of path axes. Throws InputError with
/// the name of the field.
Frame frame_of(const command::SetCoordinateTransform& what, std::size_t axes,
               std::size_t path_axes);

/// Returns the frame, shifted so that the place with these coordinates of the machine has the
/// coordinates of the command. Throws InputError "to" for no coordinate, and for one that the group
/// does not have.
Frame shifted(Frame frame, const command::GroupSetPosition& what, const Point& machine,
              std::size_t axes);

}  // namespace jounce
