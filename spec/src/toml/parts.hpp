// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <span>
#include <string>

#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/spec.hpp"

#include "spec/src/toml/motion_fields.hpp"

/// The parts of a spec, each read from its own tables of the document.
namespace jounce::spec_detail {

/// start, [[segment]] (its free values go to spec.optimize), periodic, slave_period, boundaries. Rates over time are
/// taken at the speed of spec.master.
CamSpec read_cam(TomlReader& top, const Units& units, Spec& spec);

/// The length of the knots of a cam, in the unit of the master. None if one of them is missing or wrong: read_cam()
/// reports that.
std::optional<double> cam_length(TomlReader& top, const Units& units);

/// [gear]: GearSpec, GearCourse or GearInPosPart, by its `engage`.
SyncSpec read_gear(TomlReader gear, const Units& units);

/// [follow] with [[segment]] or [[follow.table]], or [[point]] and [[zone]].
FollowPart read_follow(TomlReader& top, const Units& units);
/// [knife].
RotaryKnifeSpec read_knife(TomlReader knife, const Units& units);

/// [shear], within the [limits.slave] that were read before, and its implied master; [indexer].
FlyingShear read_shear(TomlReader shear, Spec& spec);
Indexer read_indexer(TomlReader indexer, const Units& units);

/// The name of a law; inflection, straight, shares.
std::optional<Law> read_law(TomlReader& owner, const char* key);
LawForm read_form(TomlReader& owner);

/// [optimize], with [load] if shapes are free.
void read_optimize(TomlReader& top, Spec& spec);

/// [load], if there is one; `free = { shape = ... }` of a segment; the keys of [optimize] for shapes.
std::optional<LoadSpec> read_load(TomlReader& top, const Units& units);
void read_free_shape(TomlReader& free, std::size_t segment, ShapeSpec& shape);
void read_shape_optimize(TomlReader& optimize, Spec& spec);
/// `budget`: s, > 0.
std::optional<double> read_budget(TomlReader& optimize);

/// [optimize] with [[optimize.parameter]]. Called last, after all numbers of the spec have been read.
std::optional<ParametersSpec> read_parameters(TomlReader& top, const Spec& spec);

/// [disc] with [disc.limits], if there is one.
std::optional<DiscPart> read_disc(TomlReader& top, const Units& units);

/// [polydyne], if there is one.
std::optional<Mode> read_polydyne(TomlReader& top);

/// [coupling], in s.
std::optional<CouplingSpec> read_coupling(TomlReader& top, const Units& units,
                                          const std::string& time_unit);

/// A `profile` of [move], and the function that reads its keys.
struct ProfileReader {
  const char* name;
  MoveSpec (*read)(MotionFields& fields);
};
std::span<const ProfileReader> general_profiles();
std::span<const ProfileReader> controller_profiles();

/// [move], [[knot]], [axis].
MoveSpec read_move(TomlReader move, const Units& units);
Table read_knots(TomlReader& top, Spec& spec, Interpolation rule);
AxisSpec read_axis(TomlReader axis, const Units& units);
/// [homing], if there is one.
std::optional<AxisSpec::Homing> read_homing(TomlReader& top, const Units& units);
/// [follow]: the master of an axis.
std::optional<FollowWhom> read_whom(TomlReader& owner);
/// [master.NAME]: the masters of a machine.
std::vector<MachineMasterSpec> read_masters(TomlReader& top);

/// [pt], [[point]].
TimeTableSpec read_time_table(TomlReader& top, const Units& units);

/// `outside`: refuse or hold, and wrap or advance if the motion may repeat; default: hold.
Extrapolation read_outside(TomlReader& reader, bool may_repeat);

/// Checks the units: the rules and ranges of a controller hold in its own units.
void require_unit(const char* key, const std::string& given, const std::string& wanted,
                  const std::string& who);

/// [start], [dynamics], [[command]].
QueueSpec read_queue(TomlReader& top, const Units& units);

/// True for times = "shortest", a key of knots and of points.
bool wants_shortest_times(TomlReader& top);

/// name, unit, [table], [limits] and [drive] of one axis of several. `taken`: names of the others.
AxisPart read_axis_part(TomlReader& axis, const Units& units, std::set<std::string>& taken);

/// [[axis]] into spec.axes; sync and duration, or [[point]].
AxesSpec read_axes(TomlReader& top, Spec& spec);

/// [[axis]] into spec.axes; [path], and [[command]], points or [gcode].
PathSpec read_path(TomlReader& top, Spec& spec);

/// [compare] with [compare.device], if there is one.
std::optional<CompareSpec> read_compare(TomlReader& top, const Spec& spec);

/// [[then]].
std::vector<Operator> read_then(TomlReader& top, const Spec& spec);

/// velocity, acceleration, deceleration, jerk, deceleration_jerk. Without `with_velocity` the
/// key `velocity` is left to the caller.
Dynamics read_dynamics(MotionFields& fields, bool with_velocity = true);

/// [table], [limits], and [drive] with [drive.limits] if there is one: of the document, or of one axis. [table] of a
/// spec that is a table itself (`finished`) has a rule only.
TableOptions read_table_options(TomlReader& owner, const Units& units, bool finished = false,
                                Domain axis = Domain::time);
/// The keys of [table] that ask for the fewest knots.
void read_target(TomlReader& table, const Units& units, Domain axis, TableOptions& options);
Limits read_limits(TomlReader& owner, const Units& units);
/// [limits] of a cam, per master unit, and [limits.slave], over time.
Limits read_limits(TomlReader& owner, const Units& units, Limits* slave,
                   const std::string& time_unit);
std::optional<DriveSpec> read_drive(TomlReader& owner, const Units& units);
/// [drive.tolerances] of a drive that has been read.
std::optional<ToleranceSpec> read_tolerances(TomlReader& drive_table, const Drive& drive);
/// [follower] with [follower.limits], after the [master].
std::optional<FollowerSpec> read_follower(TomlReader& top, const Spec& spec);

/// [switches], [[switch]] and [[track]]. `of`: the axis of their positions if the spec does not name it;
/// `master_period`: period of a master that repeats.
AxisSwitches read_switches(TomlReader& top, const Spec& spec, SwitchesOf of,
                           std::optional<double> master_period = {});

/// A unit of measure under `key`.
std::string read_unit(TomlReader& reader, const char* key, const char* fallback);

/// A unit of a position: of length, of angle, or pulses.
std::string read_position_unit(TomlReader& reader, const char* key, const char* fallback);

/// A unit of a master: the same, or of time for a virtual one.
std::string read_master_unit(TomlReader& reader, const char* key);

}  // namespace jounce::spec_detail
