// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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
  /// Stop at every corner: the program time that rounding is compared with.
  bool stop_at_corners = false;
  /// Joints behind the axes of the program: they are further axes of the plan.
  std::optional<JointSpace> joints = {};
};

/// Outcome of a joint, in short.
enum class JointNote : std::uint8_t {
  none,        ///< outcome as asked
  turns_back,  ///< the path reverses: the plan rests
  short_sides,  ///< the pieces on both sides are too short for what was asked; a smaller corner is used
  slower,       ///< rounding takes longer than stopping: the plan rests
  steps,  ///< tangent, but the curvature steps, and with it the acceleration; a corner mode rounds it
  no_distance,  ///< the command covers no distance and is left out
};
struct JointMark {
  std::uint32_t piece = 0;  ///< piece of the path: the corner, or the piece that begins here
  std::int32_t line = 0;
  JointNote note = JointNote::none;
  bool rests = false;
};

/// Outcome of the joint at the start of a command.
struct CornerRecord {
  std::int32_t line = 0;  ///< line of the command that begins here
  double where = 0;       ///< q of the middle
  double angle = 0;       ///< rad, of the directions that meet here; 0: tangent
  Corner asked = Corner::stop;
  double value = 0;      ///< requested value
  bool stop = false;     ///< the plan rests here
  double trim = 0;       ///< u, replaced before and after the corner
  double deviation = 0;  ///< u, corner to curve: exact
  double one_sided = 0;  ///< u, curve to corner's sides: at most
  double curvature = 0;  ///< 1/u, the greatest
  double velocity = 0;   ///< u/s, along q, at the middle
  JointNote note = JointNote::none;
  /// The note as a sentence without units; empty if all is as asked.
  std::string text;
};

/// The note of a corner as a sentence, with its numbers; lengths in `length_unit`. Empty if all is as asked.
std::string explain(const CornerRecord& corner, std::string_view length_unit = "");

/// A planned program: path and timing law.
///
///     const GroupLimits limits{.axes = std::vector<Limits>(2, {.velocity = 200, .acceleration = 1000, .jerk = 1e4})};
///     const Plan motion = plan(square, limits);
///     motion.duration();                                   // s
///     const PlanAxes axes = to_axes(motion);               // one Trajectory an axis
///     const Report report = check(axes.curves[0], limits.axes[0]);
///
/// **Promises.** The plan begins and ends at rest, exactly at the program's ends. Its axes keep every limit, by
/// exact extrema, within 1e-12: arcs, blends and curves are planned with the limits less 1e-6, and `to_axes`
/// keeps the error of its fits within half of that. It never takes longer than stop_duration(), the fastest
/// motion of the same laws that stops at each corner. It depends on nothing but its arguments.
class Plan {
 public:
  /// Input of a plan.
  struct Given {
    GroupLimits limits;  ///< limits of the axes, then of the joints
    std::vector<PathSettings> settings;
    std::size_t path_axes = 0;
    std::optional<Path> drawn = {};  ///< see Plan::drawn()
    std::optional<MapFit> fit = {};  ///< joints: how far they are from their map
  };

  Plan(Path path, TimingLaw law, std::vector<JointMark> joints, double stop_duration, Given given);

  /// All axes: those of the program, then the joints.
  [[nodiscard]] const Path& path() const { return path_; }
  /// The path with its lines, arcs and corners, which joints() and corners() count in. It is path(), unless joints are
  /// fitted: then it has the axes of the program alone, over the same q.
  [[nodiscard]] const Path& drawn() const { return given_.drawn ? *given_.drawn : path_; }
  [[nodiscard]] const TimingLaw& law() const { return law_; }
  [[nodiscard]] double duration() const { return law_.duration(); }
  /// Program time with a stop at each corner, s.
  [[nodiscard]] double stop_duration() const { return stop_duration_; }
  /// Every joint that is not tangent, and every one with a note, in the order of the path.
  [[nodiscard]] std::span<const JointMark> joints() const { return joints_; }
  /// The same with all that is known of them.
  [[nodiscard]] std::vector<CornerRecord> corners() const;

  [[nodiscard]] const Given& given() const { return given_; }

  /// Motion of every axis at t in [0, duration()], right-continuous; no allocation. out: one an axis. For many
  /// instants see PlanCursor.
  void at(double t, std::span<Motion> out) const;

 private:
  Path path_;
  TimingLaw law_;
  std::vector<JointMark> joints_;
  double stop_duration_;
  Given given_;
};

/// Evaluates a plan at one instant after the other, as Plan::at. It keeps the phases of the last instant, so that an
/// instant a little later needs no search and no square root. No allocation; the plan must outlive it.
///
///     PlanCursor cursor(motion);
///     for (double t = 0; t < motion.duration(); t += 0.001) cursor.at(t, out);
class PlanCursor {
 public:
  explicit PlanCursor(const Plan& plan) : plan_(&plan) {}
  void at(double t, std::span<Motion> out);

 private:
  void seek(double t);
  [[nodiscard]] bool is_in_piece(double q, std::size_t piece) const;

  const Plan* plan_;
  double from_ = 0, to_ = 0;  ///< s, the interval of the law that the phases cover; empty at first
  std::size_t interval_ = 0, count_ = 0, piece_ = 0;
  std::array<LawPhase, 7> phases_{};
};

/// Plans a whole program: geometry, corners, look-ahead over all commands. Pure.
///
/// Throws InputError with the source line: limits that are missing (every axis that moves needs a velocity or the
/// program a feed; and an acceleration and a jerk of axis or path), or not positive; a program that does not move.
Plan plan(const Program& program, const GroupLimits& limits, const PlanOptions& options = {});

/// One exact trajectory an axis, or a fit with its certificate.
struct PlanAxes {
  std::vector<Trajectory> curves;
  std::vector<Jet>
      error;  ///< bound of the fit's error by axis: u, u/s, u/s^2, u/s^3; 0 where exact
};

/// Axes of a plan over time, from 0. Exact on lines, on corners (degree 9) and at constant speed on arcs; where the
/// speed changes on an arc or an ellipse a fit of degree 11 within `tolerance` (unit of the axis), or within
/// rounding where that is coarser; its errors of velocity, acceleration and jerk are at most 5e-7 of the limits.
PlanAxes to_axes(const Plan& plan, double tolerance = 1e-9);

/// A proven lower bound of the duration on this path (jerk not limited): no motion along plan.path() that keeps
/// velocities and accelerations is faster. `cells` a piece for arcs and corners.
double lower_bound(const Plan& plan, int cells = 32);

}  // namespace jounce
