// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/base/document.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/cam/coupling/coupling.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/cam/disc/disc.hpp"
#include "jounce/cam/switches/cam_switch.hpp"
#include "jounce/optimize/problem.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/position_compare.hpp"
#include "jounce/pvt/reduce.hpp"
#include "jounce/spec/machine_spec.hpp"
#include "jounce/spec/motion_spec.hpp"
#include "jounce/spec/parameters_spec.hpp"
#include "jounce/spec/path_spec.hpp"
#include "jounce/spec/shape_spec.hpp"
#include "jounce/spec/sync_spec.hpp"
#include "jounce/spec/time_table_spec.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/follower.hpp"
#include "jounce/validate/tolerances.hpp"

namespace jounce {

/// Conversion of a curve to a table: the rule, and either a tolerance or a number of equal intervals.
struct TableOptions {
  /// Omitted: quintic_hermite, but cubic_hermite for a motion whose acceleration steps, and for a
  /// spec of knots.
  std::optional<Interpolation> rule;
  std::optional<double> tolerance;       ///< greatest position error, in the unit of the position
  std::optional<std::size_t> intervals;  ///< equal ones, instead of a tolerance
  /// knots = "fewest": further requirements; rule and tolerance are those above.
  std::optional<Target> target = {};
};

/// Motion of the master of a cam: a trapezoidal move from 0.
struct MasterSpec {
  double velocity = 0;                 ///< master unit / time unit
  double distance = 0;                 ///< master unit
  std::optional<double> acceleration;  ///< omitted: the (virtual) master starts at full speed
};

/// Rule for derivatives that the knots of a cam omit.
enum class Boundaries {
  rest,                       ///< zero, unless a neighbour requires another value
  minimum_jerk,               ///< least rms geo_jerk: jounce/cam/design/boundaries.hpp
  minimum_peak_acceleration,  ///< least peak geo_acceleration: jounce/optimize/least_peak.hpp
};

/// Quantities that `jounce optimize` may change, and its objective: the `free` of the knots and [optimize].
struct OptimizeSpec {
  std::vector<FreeKnot> free;
  std::vector<Objective> minimize{Objective::peak_acceleration};
  std::optional<std::size_t> seed;
  std::optional<std::size_t> starts;
  std::optional<double> tolerance;
  std::optional<double> seconds = {};  ///< time budget
  ShapeSpec shape = {};  ///< if segments are free in shape; then `minimize` above is not used
};

/// The servo axis that the table is proven against: [drive] and [drive.limits].
struct DriveSpec {
  Drive drive;
  DriveLimits limits;
  double settle = 0.2;                           ///< s of standstill after the motion's end
  bool periodic = false;                         ///< the motion repeats endlessly: its steady state
  std::vector<Interval> sync = {};               ///< [[drive.sync]], s of the motion
  std::optional<ToleranceSpec> tolerances = {};  ///< [drive.tolerances]

  [[nodiscard]] DriveOptions options(std::size_t samples = 0) const {
    return {
        .settle = settle, .samples = samples, .limits = limits, .sync = sync, .periodic = periodic};
  }
};

/// The cam follower that the lift is proven against: [follower] and [follower.limits].
struct FollowerSpec {
  SpringFollower follower;
  FollowerLimits limits;
  double settle = 0;  ///< s of standstill after the motion's end
};

/// The plate that a cam is cut into: [disc] and [disc.limits].
struct DiscPart {
  DiscSpec geometry;
  DiscLimits limits;
  double tolerance = 0;              ///< tolerance of the contour
  std::optional<double> hub_radius;  ///< a circle of the drawing
  std::string length;  ///< unit of all lengths: the slave's unit, or mm if the slave is an angle
};

/// An axis as its executor is configured: `jounce run` takes it, with [limits] over time.
struct AxisSpec {
  /// [homing], as in jounce/axis/axis_config.hpp, in u and the spec's unit of time. A velocity or
  /// acceleration of 0 means that it was omitted.
  struct Homing {
    int method = 37;
    double search_velocity = 0;
    double index_velocity = 0;
    double acceleration = 0;
    double offset = 0;
    double timeout = 60;  ///< s
    std::optional<double> distance = {};
  };

  double cycle = 1e-3;  ///< s
  double position = 0;  ///< position at the start
  // Stops and supervision, see jounce/axis/axis_config.hpp; 0: not given. In u and the spec's time.
  double modulo = 0;
  double stop_acceleration = 0;
  double stop_jerk = 0;
  double abort_acceleration = 0;
  double limit_acceleration = 0;
  double following_error = 0;
  double following_time = 0;  ///< s
  double in_position = 0;
  double in_position_time = 0;  ///< s
  double longest_gap = 0;       ///< s; 0: 100 cycles
  double session_timeout = 1;   ///< s without a message, after which the owner loses the axis
  bool require_home = false;
  std::optional<Homing> homing = {};
  std::optional<FollowWhom> follow = {};  ///< its live master
};

/// A drive alone: for `jounce identify`, and as the drive for optimising a cam.
struct DriveAlone {};

/// The data of one axis of a spec. A spec with a single axis has one AxisPart, without a name.
struct AxisPart {
  std::string name;
  Units units;
  TableOptions table;
  Limits limits;  ///< for a cam: per master unit
  std::optional<DriveSpec> drive;
};

/// An output that is fired along the motion of one axis: [compare] and [compare.device].
struct CompareSpec {
  std::string axis = {};  ///< the axis, if the spec has several; "path": the length along the path
  SwitchesOf of = SwitchesOf::position;  ///< for kind "axis": position, or actual
  PositionCompare compare;
  CompareDevice device;                    ///< in the spec's unit of time
  std::optional<PlaneCompare> plane = {};  ///< modes "zone" and "zone_equal": of two axes
  std::array<std::string, 2> plane_axes = {};
};

/// A complete spec file: the motion, its axes and its limits.
struct Spec {
  static constexpr int version = 1;  ///< the `jounce = 1` of the file

  Document document;
  std::string name;
  Units units;              ///< x is the master's unit for a cam, the time's for the others
  std::string time_unit;    ///< "s" by default
  std::string master_unit;  ///< master unit of an axis that follows a master; otherwise ""
  std::variant<CamSpec, SyncSpec, MoveSpec, QueueSpec, AxesSpec, PathSpec, Table, TimeTableSpec,
               AxisSpec, DriveAlone>
      subject;
  std::vector<Operator> then;  ///< operators on the motion, one after another
  std::vector<AxisPart> axes;  ///< axes of kinds "axes" and "path"; empty for the others
  Boundaries boundaries = Boundaries::rest;  ///< for a cam
  TableOptions table;
  Limits limits;  ///< for a cam: per master unit
  Limits slave;   ///< for a cam: [limits.slave], over time; without positions
  std::optional<MasterSpec> master;
  std::optional<CouplingSpec> coupling;  ///< for a cam: how `jounce stream` engages it; in s
  OptimizeSpec optimize;
  std::optional<ParametersSpec> parameters;  ///< chosen by `jounce optimize`
  std::optional<DriveSpec> drive;
  std::optional<DiscPart> disc;  ///< for a cam
  std::optional<Mode>
      polydyne;  ///< for a cam: its knots define the motion of the load behind this mode (Hz)
  std::optional<FollowerSpec> follower = {};  ///< for a cam with a master
  AxisSwitches switches;                      ///< for kinds "axis" and "cam"
  std::optional<CompareSpec> compare;         ///< for a motion over time
  bool himc = false;                          ///< for kind "pvt": for HIMC's MovePVT
  Report fill;  ///< for kind "pvt": the findings from filling in omitted velocities

  // Defined in spec.cpp, because inline they would take seconds to compile in every file that copies
  // a spec.
  Spec();
  Spec(const Spec& other);
  Spec(Spec&& other) noexcept;
  Spec& operator=(const Spec& other);
  Spec& operator=(Spec&& other) noexcept;
  ~Spec();

  /// The axes: those of kinds "axes" and "path", or the one.
  [[nodiscard]] std::vector<AxisPart> parts() const;

  /// True if it describes a cam, given by knots or by a synchronous slave, rather than a motion.
  [[nodiscard]] bool over_master() const {
    return std::holds_alternative<CamSpec>(subject) || std::holds_alternative<SyncSpec>(subject);
  }
  /// The period of a periodic cam, in the master's unit.
  [[nodiscard]] std::optional<double> master_period() const;
};

/// Reads a spec (TOML, format version 1). Throws InputError with file, line, column, key, value and
/// rule: syntax, unknown keys (with the nearest known one), a missing key, a wrong type, unit or
/// version, a number that is not finite, an unknown choice. Throws InputErrors for several errors that do not depend on
/// each other.
Spec read_spec(const std::string& path);

/// The same from text; messages use `name` as the file name.
Spec parse_spec(std::string text, std::string name);

/// The kind that a spec names: "cam", "machine", "sweep", ...; empty if it is not TOML or names none.
std::string spec_kind(const std::string& text);

}  // namespace jounce
