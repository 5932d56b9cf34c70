// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jounce/path/axis_map.hpp"
#include "jounce/path/group_limits.hpp"
#include "jounce/path/law.hpp"
#include "jounce/path/path.hpp"
#include "jounce/path/program.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Options of a plan.
struct PlanOptions {
  /// True: stop at every corner, for example to show the duration of the program without rounded
  /// corners.
  bool stop_at_corners = false;
  /// Joints of the machine (axis_map.hpp). They become further axes of the plan, after the axes of
  /// the program.
  std::optional<JointSpace> joints = {};
  /// If this becomes true during the call, for example in another thread, plan() throws
  /// PlanCanceled within a few milliseconds; null: never.
  const std::atomic<bool>* canceled = nullptr;
};

/// Thrown by plan() if it is canceled.
struct PlanCanceled : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "the plan was canceled"; }
};

/// Note on a *junction* of the path: a place where two pieces meet.
enum class JunctionNote : std::uint8_t {
  none,        ///< the result is as requested
  turns_back,  ///< the path reverses: the plan stops
  /// The adjacent pieces are too short for the requested corner; a smaller one is used.
  short_sides,
  /// The rounded corners between two rests would together take longer than stops: the plan stops at
  /// each of them.
  slower,
  /// The junction is tangential, but the curvature steps, and with it the acceleration. A corner
  /// mode rounds the junction.
  steps,
  no_distance,  ///< the command covers no distance and is omitted
};
/// A junction of the path with its note.
struct JunctionMark {
  /// Index of a piece: the corner at the junction, or the piece that begins at the junction.
  std::uint32_t piece = 0;
  std::int32_t line = 0;  ///< source line
  JunctionNote note = JunctionNote::none;
  bool rests = false;  ///< true: the plan stops here
};

/// Full result of the junction at the start of a command. u is the axes' unit of length, q the path
/// parameter (path.hpp).
struct CornerRecord {
  std::int32_t line = 0;        ///< source line of the command that begins here
  double where = 0;             ///< q of the middle of the corner
  double angle = 0;             ///< rad, angle between the directions before and after the corner;
                                ///< 0: tangential
  Corner asked = Corner::stop;  ///< requested kind of corner
  double value = 0;             ///< requested value
  bool stop = false;            ///< true: the plan stops here
  double trim = 0;              ///< u, length that the corner replaces on each side
  double deviation = 0;         ///< u, exact distance from the corner point to the curve that
                                ///< rounds it
  /// u, upper bound of the distance from this curve to the sides of the corner.
  double one_sided = 0;
  double curvature = 0;  ///< 1/u, greatest curvature
  double velocity = 0;   ///< u/s, velocity along q at the middle
  JunctionNote note = JunctionNote::none;
  /// The note as a sentence without units; empty if the result is as requested.
  std::string text = {};
};

/// Returns the note of a corner as a sentence with its numbers; lengths are in `length_unit`. Empty
/// if the result is as requested.
std::string explain(const CornerRecord& corner, std::string_view length_unit = "");

/// A planned program: its path and its timing law.
///
///     const Limits axis{.velocity = 200, .acceleration = 1000, .jerk = 1e4};
///     const GroupLimits limits{.axes = std::vector<Limits>(2, axis)};
///     const Plan motion = plan(square, limits);            // square: see program.hpp
///     motion.duration();                                   // s
///     const PlanAxes axes = to_axes(motion);               // one Trajectory for each axis
///     const Report report = check(axes.curves[0], limits.axes[0]);
///
/// **Guarantees.** The plan begins and ends at rest, exactly at the start and end of the program.
/// Every axis stays within its limits of velocity, acceleration and jerk, to 1e-12, by exact
/// extrema; position limits are checked only at the ends of commands (see GroupLimits). (Arcs,
/// blends and curves are planned with limits that are lower by 1e-6; the error of the fits of
/// to_axes() is at most half of this margin.) The plan never takes longer than stop_duration(): the
/// duration of the fastest motion that has laws of the same kind and stops at each corner. The plan
/// depends only on its arguments.
class Plan {
 public:
  /// Data from which the plan was made.
  struct Given {
    GroupLimits limits = {};                  ///< limits of the axes, then of the joints
    std::vector<PathSettings> settings = {};  ///< settings of the commands
    std::size_t path_axes = 0;                ///< number of path axes
    std::optional<Path> drawn = {};           ///< set only if drawn() differs from path()
    /// for joints of the machine: distance of the planned joints from the map
    std::optional<MapFit> fit = {};
  };

  /// Used by plan() and the functions of hold.hpp and override.hpp, which make plans.
  Plan(Path path, TimingLaw law, std::vector<JunctionMark> junctions, double stop_duration,
       Given given);

  /// The path of all axes: the axes of the program, then the joints of the machine.
  [[nodiscard]] const Path& path() const { return path_; }
  /// The path with its lines, arcs and corners. junctions() and corners() refer to the pieces of
  /// this path. drawn() equals path(), unless joints of the machine are fitted: then drawn() has
  /// only the axes of the program, as functions of the same q.
  [[nodiscard]] const Path& drawn() const { return given_.drawn ? *given_.drawn : path_; }
  [[nodiscard]] const TimingLaw& law() const { return law_; }
  [[nodiscard]] double duration() const { return law_.duration(); }  ///< s
  /// Duration with a stop at each corner, s.
  [[nodiscard]] double stop_duration() const { return stop_duration_; }
  /// All junctions of the path that are not tangential or have a note, in the order of the path.
  [[nodiscard]] std::span<const JunctionMark> junctions() const { return junctions_; }
  /// Returns the junctions of the path with their full results.
  [[nodiscard]] std::vector<CornerRecord> corners() const;

  [[nodiscard]] const Given& given() const { return given_; }

  /// Writes the motion of every axis at time t (s) in [0, duration()] to `out`, which has one entry
  /// for each axis; otherwise the function throws InputError. At a step, writes the value after the
  /// step. Does not allocate. For many instants use PlanCursor.
  void at(double t, std::span<Motion> out) const;

 private:
  Path path_;
  TimingLaw law_;
  std::vector<JunctionMark> junctions_;
  double stop_duration_;
  Given given_;
};

/// Evaluates a plan at successive instants. The results equal the results of Plan::at(). The cursor
/// stores the phases of the last instant, so evaluating a slightly later instant needs no search
/// and no square root. Does not allocate. The plan must outlive the cursor.
///
///     PlanCursor cursor(motion);
///     for (double t = 0; t < motion.duration(); t += 0.001) cursor.at(t, out);
class PlanCursor {
 public:
  /// `plan` must outlive the cursor.
  explicit PlanCursor(const Plan& plan) : plan_(&plan) {}
  /// Writes the motion of every axis at time t, s, like Plan::at().
  void at(double t, std::span<Motion> out);

 private:
  void seek(double t);
  [[nodiscard]] bool is_in_piece(double q, std::size_t piece) const;

  const Plan* plan_;
  double from_ = 0, to_ = 0;  ///< s, interval of the law that phases_ covers; empty at first
  LawStretches::Iterator interval_;
  std::size_t count_ = 0, piece_ = 0;
  std::array<LawPhase, 7> phases_{};
};

/// Plans a whole program: its geometry, its corners, and its velocities with look-ahead over all
/// commands. A pure function.
///
/// Requires a velocity limit for every axis that moves or a feed of the program, and limits of
/// acceleration and jerk of the axes or of the path. Throws InputError, with the source line, if a
/// limit is missing or not positive, if the end of a command is outside the position limits of an
/// axis, or if the program does not move.
Plan plan(const Program& program, const GroupLimits& limits, const PlanOptions& options = {});

/// The axes of a plan over time.
struct PlanAxes {
  std::vector<Trajectory> curves = {};  ///< one for each axis
  /// For each axis, a bound of the error of its fit: u, u/s, u/s^2, u/s^3; 0: exact.
  std::vector<Jet> error = {};
};

/// Returns the axes of a plan over time, from 0 s. The result is exact on lines, on corners (degree
/// 9), and on arcs at constant speed. Where the speed changes on an arc or an ellipse, it is a fit
/// of degree 11 within `tolerance` (unit of the axis) or within rounding, whichever is greater. The
/// errors of velocity, acceleration and jerk are at most 5e-7 of the limits.
PlanAxes to_axes(const Plan& plan, double tolerance = 1e-9);

/// Returns a proven lower bound (s) of the duration on the path plan.path() without jerk limits: no
/// motion along this path within the limits of velocity and acceleration is faster. `cells` is the
/// number of parts into which each arc and corner is divided.
double lower_bound(const Plan& plan, int cells = 32);

}  // namespace jounce
