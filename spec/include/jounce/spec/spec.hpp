// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
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
#include "jounce/gear/live_registration.hpp"
#include "jounce/optimize/problem.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/position_compare.hpp"
#include "jounce/pvt/reduce.hpp"
#include "jounce/spec/machine_spec.hpp"
#include "jounce/spec/motion_spec.hpp"
#include "jounce/spec/named_cam.hpp"
#include "jounce/spec/parameters_spec.hpp"
#include "jounce/spec/path_spec.hpp"
#include "jounce/spec/shape_spec.hpp"
#include "jounce/spec/sync_spec.hpp"
#include "jounce/spec/time_table_spec.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/follower.hpp"
#include "jounce/validate/tolerances.hpp"

namespace jounce {

/// Conversion of a curve to a table: the rule, and a tolerance or a number of equal intervals.
struct TableOptions {
  /// Interpolation rule. Omitted: quintic_hermite; for a motion whose acceleration steps, and for a
  /// spec of knots, cubic_hermite; for a table over time whose velocity steps, linear.
  std::optional<Interpolation> rule = {};
  /// Greatest position error, in the unit of the position; if it and `intervals` are omitted: 1e-9
  /// of the stroke (table over time with rule linear: 1e-6).
  std::optional<double> tolerance = {};
  std::optional<std::size_t> intervals = {};  ///< number of equal intervals, instead of a tolerance
  /// For knots = "fewest": further requirements. Rule and tolerance are the members above.
  std::optional<Target> target = {};
};

/// Motion of the master of a cam: a move with trapezoidal velocity from the start of the cam.
struct MasterSpec {
  double velocity = 0;  ///< master unit / time unit
  double distance = 0;  ///< master unit
  /// Master unit / time unit^2; omitted: the (virtual) master starts at full speed.
  std::optional<double> acceleration = {};
};

/// Quantities of a cam that `jounce optimize` may change, and its objectives: the keys `free` of
/// the knots, and section [optimize].
struct OptimizeSpec {
  std::vector<FreeKnot> free = {};  ///< knots with free values
  /// Objectives, the most important first.
  std::vector<Objective> minimize{Objective::peak_acceleration};
  std::optional<std::size_t> seed = {};    ///< seed of the random starts
  std::optional<std::size_t> starts = {};  ///< number of starts of the search
  std::optional<double> tolerance = {};    ///< relative tolerance of the objective
  std::optional<double> seconds = {};      ///< s, greatest duration of the search
  /// Free shapes of segments. If the spec has any, `minimize` above is not used.
  ShapeSpec shape = {};
};

/// The servo axis that `jounce validate` simulates with the table: [drive] and [drive.limits].
struct DriveSpec {
  Drive drive = {};
  DriveLimits limits = {};
  double settle = 0.2;    ///< s, standstill after the end of the motion
  bool periodic = false;  ///< true: the motion repeats endlessly, and the steady state is simulated
  std::vector<Interval> sync = {};               ///< [[drive.sync]]: s, intervals of the motion
  std::optional<ToleranceSpec> tolerances = {};  ///< [drive.tolerances]

  /// Returns the options of the simulation.
  [[nodiscard]] DriveOptions options(std::size_t samples = 0) const {
    return {
        .settle = settle, .samples = samples, .limits = limits, .sync = sync, .periodic = periodic};
  }
};

/// The cam follower that `jounce validate` simulates with the lift: [follower] and
/// [follower.limits].
struct FollowerSpec {
  SpringFollower follower = {};
  FollowerLimits limits = {};
  double settle = 0;  ///< s, standstill after the end of the motion
};

/// The plate of a disc cam: [disc] and [disc.limits].
struct DiscPart {
  DiscSpec geometry = {};
  DiscLimits limits = {};
  double tolerance = 0;                   ///< tolerance of the contour, in `length`
  std::optional<double> hub_radius = {};  ///< radius of a circle in the drawing
  std::string length =
      {};  ///< unit of all lengths: the slave's unit or, if the slave is an angle, mm
};

/// The configuration of an axis for `jounce run`, in addition to its [limits] over time.
struct AxisSpec {
  /// [homing], as in jounce/axis/axis_config.hpp, in u and the spec's unit of time. A velocity or
  /// acceleration of 0 means that the key is omitted.
  struct Homing {
    int method = 37;             ///< CiA 402 homing method (6098h)
    double search_velocity = 0;  ///< velocity of the search for the switch
    double index_velocity = 0;   ///< velocity of the search for the edge and the index
    double acceleration = 0;
    double offset = 0;    ///< position value of the axis at the home position
    double timeout = 60;  ///< s, greatest duration
    std::optional<double> distance = {};
  };

  /// [compensation]: the table, with the name and the unit of each reference. "": the axis itself.
  struct Compensation {
    CompensationSpec table = {};
    std::vector<std::string> axes = {};
    std::vector<std::string> units = {};
  };

  double cycle = 1e-3;  ///< s, period of the cyclic thread
  double position = 0;  ///< u, position at the start
  // Stops and supervision, see jounce/axis/axis_config.hpp. 0 means that the key is omitted. Units:
  // u and the spec's unit of time.
  double modulo = 0;              ///< u, period of a modulo axis
  double stop_acceleration = 0;   ///< deceleration of a stop
  double stop_jerk = 0;           ///< jerk of a stop
  double abort_acceleration = 0;  ///< deceleration of an abort; 0: the setpoint freezes
  double limit_acceleration = 0;  ///< deceleration before a soft limit
  double following_error = 0;     ///< u, greatest following error
  double following_time = 0;      ///< s, time for which the following error may exceed the limit
  double in_position = 0;         ///< u, window for "in position"
  double in_position_time = 0;    ///< s, time for which the error must stay in the window
  /// s, delay of a cycle that causes a fault during a motion; 0: 100 cycles
  double longest_gap = 0;
  /// s; after this time without a message, the session ends and the axis is free.
  double session_timeout = 1;
  bool require_home = false;  ///< true: motions to absolute positions are rejected before homing
  std::string cutter = {};    ///< spec of its knife or shear, relative to the axis' file; "": none
  std::optional<Homing> homing = {};
  std::optional<FollowWhom> follow = {};                  ///< the leader that the axis follows
  std::optional<LiveRegistrationSpec> registration = {};  ///< [registration]
  std::optional<Compensation> compensation = {};          ///< [compensation]
};

/// A spec of kind "drive": a drive without an axis, for `jounce identify` and for optimizing a cam.
struct DriveAlone {};

/// The data of one axis of a spec. A spec of a single axis has one AxisPart, without a name.
struct AxisPart {
  std::string name = {};    ///< name of the axis
  Units units = {};         ///< units of the axis
  TableOptions table = {};  ///< conversion of its curve to a table
  Limits limits = {};       ///< limits; for a cam, per master unit
  std::optional<DriveSpec> drive = {};
};

/// An output that fires during the motion of one axis: [compare] and [compare.device].
struct CompareSpec {
  std::string axis = {};  ///< the axis, if the spec has several; "path": the output fires at
                          ///< lengths along the path
  /// For kind "axis": setpoint (`position`) or actual position.
  SwitchesOf of = SwitchesOf::position;
  PositionCompare compare = {};  ///< points and mode
  CompareDevice device = {};     ///< in the spec's unit of time
  /// Modes "zone" and "zone_equal": position compare in a plane of two axes.
  std::optional<PlaneCompare> plane = {};
  std::array<std::string, 2> plane_axes = {};  ///< names of these two axes
};

/// A complete spec: the motion, its axes and its limits.
struct Spec {
  static constexpr int version = 1;  ///< value of the key `jounce` in the file

  Document document;  ///< the file, for places in messages
  std::string name;   ///< name of the motion
  Units units;        ///< units of x and the position; x is the master of a cam, otherwise the time
  std::string time_unit;    ///< unit of time; default "s"
  std::string master_unit;  ///< unit of the master that an axis follows; otherwise ""
  /// NamedCam: a cam of kind "cam" that is made from another file (`from`), or changed by
  /// [[then]]. The reader makes this cam, because the speed of [master] may be given in periods of
  /// the cam.
  std::variant<CamSpec, SyncSpec, MoveSpec, QueueSpec, AxesSpec, PathSpec, Table, TimeTableSpec,
               AxisSpec, DriveAlone, NamedCam>
      subject;
  std::vector<Operator> then;  ///< [[then]] of a motion over time: its operators, in order
  std::vector<AxisPart> axes;  ///< the axes of kinds "axes" and "path"; empty for other kinds
  Boundaries boundaries = Boundaries::rest;  ///< for a cam
  TableOptions table;                        ///< conversion to a table
  Limits limits;                             ///< [limits]; for a cam, per master unit
  Limits slave;                      ///< for a cam: [limits.slave], over time, without positions
  std::optional<MasterSpec> master;  ///< for a cam: [master]
  /// For a cam: the coupling with which `jounce stream` engages the cam; times in s.
  std::optional<CouplingSpec> coupling;
  OptimizeSpec optimize;  ///< for a cam: [optimize]
  /// [[optimize.parameter]]: parameters that `jounce optimize` may change.
  std::optional<ParametersSpec> parameters;
  std::optional<DriveSpec> drive;  ///< [drive]
  std::optional<DiscPart> disc;    ///< for a cam: [disc]
  /// For a cam: the mode (Hz) of a load on a spring. The knots then define the motion of the load.
  std::optional<Mode> polydyne;
  std::optional<FollowerSpec> follower = {};  ///< for a cam with a master: [follower]
  AxisSwitches switches;                      ///< for kinds "axis" and "cam": [[switch]]
  std::optional<CompareSpec> compare;         ///< for a motion over time: [compare]
  bool himc = false;                          ///< for kind "pvt": true for MovePVT of HIMC
  Report fill;  ///< for kind "pvt": findings from filling in omitted velocities

  // Defined in spec.cpp: inline, they would cost seconds of compile time in every file that copies
  // a spec.
  Spec();
  Spec(const Spec& other);
  Spec(Spec&& other) noexcept;
  Spec& operator=(const Spec& other);
  Spec& operator=(Spec&& other) noexcept;
  ~Spec();

  /// Returns all axes: `axes` for the kinds "axes" and "path", otherwise the only axis.
  [[nodiscard]] std::vector<AxisPart> parts() const;

  /// True for a spec of kind "cam".
  [[nodiscard]] bool is_cam() const {
    return std::holds_alternative<CamSpec>(subject) || std::holds_alternative<NamedCam>(subject);
  }
  /// True for a cam, including the cam of a synchronous slave; false for a motion over time.
  [[nodiscard]] bool over_master() const {
    return is_cam() || std::holds_alternative<SyncSpec>(subject);
  }
  /// Period of a periodic cam, in the master's unit; nullopt for any other spec.
  [[nodiscard]] std::optional<double> master_period() const;
};

/// Reads a spec (TOML, format version 1). Throws InputError with file, line, column, key, value and
/// rule for an error of syntax, an unknown key (with the nearest known key), a missing key, a wrong
/// type, unit or version, a number that is not finite, and an unknown word. If several errors do
/// not depend on each other, throws InputErrors.
Spec read_spec(const std::string& path);

/// Reads a spec from text; messages use `name` as the file name. Calls `use` with the spec, unless
/// a value is faulty. An error that `use` throws is reported together with the unknown keys of the
/// spec.
Spec parse_spec(std::string text, std::string name,
                const std::function<void(const Spec&)>& use = {});

/// Returns the kind of a spec: "cam", "machine", "sweep", ...; empty if the text is not TOML or has
/// no kind.
std::string spec_kind(const std::string& text);

}  // namespace jounce
