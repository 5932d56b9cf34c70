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

/// Rounding of the corner at the start of a command.
enum class Corner : std::uint8_t {
  stop,       ///< exact corner, at rest (TM_NONE, TMNone, G61)
  deviation,  ///< at most `value` from the corner, and the curve from the corner's sides (G64 P)
  distance,  ///< begins at most `value` before the corner and ends at most so far behind (TMCornerDistance)
  curvature,  ///< curvature at most `value`, 1/u (HIMC MAX_CORNER_CURV)
  velocity,   ///< passed at `value` u/s, with the least deviation (HIMC CONST_VEL)
  average,    ///< runs of short lines: averaged over a window, at most `value` from the lines
};

/// Wished velocity at the start of a command (PLCopen part 4, Table 7.1 of PMC600). Limits still hold: the
/// plan passes at the wish or slower.
enum class Junction : std::uint8_t {
  buffered,           ///< at rest
  blending_low,       ///< the lower one of the two feeds
  blending_previous,  ///< the feed of the command before
  blending_next,      ///< the feed of the new command
  blending_high,      ///< the higher one of the two feeds
  look_ahead,         ///< the highest velocity that the limits allow
};

/// Modal settings: they hold for all commands from here on. `corner` and `junction` act at the START of the
/// commands that carry them (HMPL manual 8.1.6, Example 3-1).
struct PathSettings {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double velocity = none;      ///< feed along the path, u/s, > 0
  double acceleration = none;  ///< along the path, u/s^2, > 0
  double deceleration = none;  ///< u/s^2, > 0
  double jerk = none;          ///< u/s^3, > 0
  Corner corner = Corner::stop;
  double value =
      0;  ///< deviation, distance (u), curvature (1/u) or velocity (u/s), > 0; unused by stop
  Junction junction = Junction::look_ahead;

  bool operator==(const PathSettings&) const = default;
};

/// Commands of a group as plain data: what a controller's queue, a record table or a G-code file holds.
///
///     Program square(2);                                           // two axes, from the origin
///     square.set({.velocity = 100, .corner = Corner::deviation, .value = 0.05});
///     square.line({100, 0});
///     square.line({100, 100});
///     square.arc(arc_about(square.position(), {50, 100}, {0, 100}, Plane{0, 1}, ArcRotation::counterclockwise));
///     square.dwell(0.5);
///
/// **Positions are absolute.** For relative commands add position(). `line` of each command is that of its
/// source (0: none): errors and findings name it.
///
/// **Length.** The first `path_axes` axes form the space in which lengths, feeds and deviations are
/// measured; the other axes are followers, in proportion to the length. A command that moves followers alone
/// is measured by them.
///
/// **Throws** InputError with the source line for values that are not finite or out of range.
class Program {
 public:
  /// `axes` from 1 to max_axes; `path_axes` = 0: all of them.
  explicit Program(std::size_t axes, const Point& start = {}, std::size_t path_axes = 0);

  void set(const PathSettings& settings);
  void line(const Point& to, int line = 0);
  void arc(const Arc& arc, int line = 0);
  /// A spline or an ellipse, which begins at position().
  void curve(const PathCurve& curve, int line = 0);
  /// Rest of any duration in s, >= 0; not rounded to a cycle.
  void dwell(double seconds, int line = 0);

  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] std::size_t path_axes() const { return path_axes_; }
  [[nodiscard]] const Point& start() const { return start_; }
  /// End of the last command.
  [[nodiscard]] const Point& position() const { return position_; }

  enum class Kind : std::uint8_t { line, arc, curve, dwell };
  struct Command {
    std::size_t data = 0;  ///< first number: a line's end, a dwell; index into arcs() or curves()
    int line = 0;          ///< line of the source
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
