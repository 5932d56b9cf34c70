// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "jounce/path/arc.hpp"
#include "jounce/path/point.hpp"
#include "jounce/path/shapes.hpp"

namespace jounce {

/// Kind of the corner at the start of a command. `value` is PathSettings::value. u is the axes'
/// unit of length.
enum class Corner : std::uint8_t {
  stop,  ///< exact corner with a stop (TM_NONE, TMNone, G61)
  /// Rounded: the distance between corner point and curve is at most `value` (u), and so is the
  /// distance between the curve and the sides of the corner (G64 P).
  deviation,
  /// Rounded: the curve begins at most `value` (u) before the corner and ends at most `value` after
  /// the corner (TMCornerDistance).
  distance,
  curvature,  ///< rounded: curvature at most `value`, 1/u (HIMC MAX_CORNER_CURV)
  velocity,   ///< rounded: passed at `value`, u/s, with the least deviation (HIMC CONST_VEL)
  average,    ///< sequence of short lines: one smooth curve at most `value` (u) from the lines
};

/// Requested velocity at the start of a command (PLCopen part 4; Table 7.1 of the PMC600 manual).
/// If the limits do not permit the requested velocity, it is lower.
enum class Junction : std::uint8_t {
  buffered,           ///< at rest
  blending_low,       ///< the lower of the two feeds
  blending_previous,  ///< the feed of the previous command
  blending_next,      ///< the feed of the new command
  blending_high,      ///< the higher of the two feeds
  look_ahead,         ///< the highest velocity within the limits
};

/// Further limits of an axis in a command: magnitudes > 0; default: no further limit. u is the unit
/// of the axis.
struct AxisRates {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double velocity = none;      ///< u/s
  double acceleration = none;  ///< u/s^2
  double jerk = none;          ///< u/s^3

  bool operator==(const AxisRates&) const = default;
};

/// Modal settings: they apply to all following commands. `corner` and `junction` apply to the start
/// of each of these commands (HMPL manual 8.1.6, Example 3-1).
struct PathSettings {
  static constexpr double none = std::numeric_limits<double>::infinity();  ///< no limit

  double velocity = none;        ///< u/s, > 0: feed along the path
  double acceleration = none;    ///< u/s^2, > 0: along the path
  double deceleration = none;    ///< u/s^2, > 0: along the path
  double jerk = none;            ///< u/s^3, > 0: along the path
  Corner corner = Corner::stop;  ///< kind of the corner at the start of a command
  double value = 0;              ///< > 0; its meaning and unit depend on `corner`; not used by stop
  Junction junction = Junction::look_ahead;  ///< requested velocity at the start of a command
  /// Further limits of the axes of the program, then of the joints; axes beyond the last entry have
  /// none. These limits change the velocities, not the path: a corner keeps the shape that it has
  /// without these limits. On a corner, the limits of both commands apply.
  std::vector<AxisRates> axes = {};

  bool operator==(const PathSettings&) const = default;
};

/// A program: the commands of a group as plain data, as in a controller's queue, a record table or
/// a G-code file.
///
///     Program square(2);                                           // two axes, from the origin
///     square.set({.velocity = 100, .corner = Corner::deviation, .value = 0.05});
///     square.line({100, 0});
///     square.line({100, 100});
///     square.arc(arc_about(square.position(), {50, 100}, {0, 100}, Plane{0, 1},
///                          ArcRotation::counterclockwise));
///     square.dwell(0.5);
///
/// **Positions are absolute.** For a relative command, add position(). The argument `line` of a
/// command is its source line, which errors and findings show; 0: none.
///
/// **Length.** Lengths, feeds and deviations are measured in the first `path_axes` axes. The other
/// axes are *followers*: they move in proportion to the length. If a command moves only followers,
/// its length is measured in the followers.
///
/// **Throws** InputError with the source line if a value is not finite, if it is out of range, or
/// if an arc or a curve does not begin at position().
class Program {
 public:
  /// `axes`: 1 to max_axes. `path_axes`: number of path axes; 0: all axes.
  explicit Program(std::size_t axes, const Point& start = {}, std::size_t path_axes = 0);

  void set(const PathSettings& settings);    ///< settings of the following commands
  void line(const Point& to, int line = 0);  ///< adds a line
  void arc(const Arc& arc, int line = 0);    ///< adds an arc, which begins at position()
  /// Adds a spline or an ellipse, which begins at position().
  void curve(const PathCurve& curve, int line = 0);
  /// Adds a dwell of any duration, s, >= 0; the duration is not rounded to a cycle.
  void dwell(double seconds, int line = 0);

  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] std::size_t path_axes() const { return path_axes_; }
  [[nodiscard]] const Point& start() const { return start_; }
  /// End of the last command; start() if the program has no command.
  [[nodiscard]] const Point& position() const { return position_; }

  /// Place at the start of a command, or at the end of the program for the number of its commands.
  [[nodiscard]] Point place_before(std::size_t command) const;
  /// The commands from `first` to before `last` as a program, from the place where they begin.
  [[nodiscard]] Program part(std::size_t first, std::size_t last) const;

  enum class Kind : std::uint8_t { line, arc, curve, dwell };
  /// A command, for the reader of a program.
  struct Command {
    /// Index of the command's first number (end of a line, duration of a dwell), or index into
    /// arcs() or curves().
    std::size_t data = 0;
    int line = 0;                ///< source line
    std::uint32_t settings = 0;  ///< index into settings()
    Kind kind = Kind::line;
  };
  [[nodiscard]] std::span<const Command> commands() const { return commands_; }
  [[nodiscard]] std::span<const double> numbers() const { return numbers_; }
  [[nodiscard]] std::span<const Arc> arcs() const { return arcs_; }
  [[nodiscard]] std::span<const PathCurve> curves() const { return curves_; }
  [[nodiscard]] std::span<const PathSettings> settings() const { return settings_; }

 private:
  std::size_t axes_, path_axes_;
  Point start_, position_;
  std::vector<Command> commands_;
  std::vector<double> numbers_;
  std::vector<Arc> arcs_;
  std::vector<PathCurve> curves_;
  std::vector<PathSettings> settings_{PathSettings{}};
};

}  // namespace jounce
