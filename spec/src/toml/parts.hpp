// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>

#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/spec.hpp"

#include "spec/src/toml/motion_fields.hpp"

/// Readers for the parts of a spec, each from its own tables of the document.
namespace jounce::spec_detail {

/// Reads start, [[segment]] (its free values go to spec.optimize), periodic, slave_period,
/// boundaries.
CamSpec read_cam(TomlReader& top, const Units& units, Spec& spec);

/// Reads the operators of [[then]], and applies them to a cam. `units`: the units of the result.
NamedCam read_cam_then(TomlReader& top, NamedCam cam, const Units& units);
/// The same for the cam of `from`; reads also `periodic`.
NamedCam read_cam_from(TomlReader& top, const NamedCam& source, const Units& units);
/// The units of the cam before [[then]], if the units after it are `units`, and conversely: the
/// operator `inverse` exchanges them.
Units units_before_then(TomlReader& top, const Units& units);

/// The length of the knots of a cam, in the unit of the master. None if one of them is missing or wrong: read_cam()
/// reports that.
std::optional<double> cam_length(TomlReader& top, const Units& units);
/// Throws InputError if the last knot of a cam is not after the knot before it. Knots that are missing
/// or are no numbers are the matter of read_cam().
void require_last_knot(TomlReader& top, const Units& units);
/// Reads [gear]: a GearSpec, GearCourse or GearInPosPart, depending on its key `engage`.
SyncSpec read_gear(TomlReader gear, const Units& units);

/// Reads [follow] with [[segment]] or [[follow.table]], or [[point]] and [[zone]].
FollowPart read_follow(TomlReader& top, const Units& units);
/// Reads the list of pieces of a cutter: lengths, first, waste. nullopt: none of them is given.
std::optional<CutList> read_cut_list(TomlReader& cutter, const std::string& master);
/// The cutter with its list, if there is one.
SyncSpec with_list(CutMachine machine, std::optional<CutList> list);
/// Reads [knife]: a RotaryKnifeSpec or a CutListSpec.
SyncSpec read_knife(TomlReader knife, const Units& units);

/// Reads [shear], for the limits of [limits.slave] that were read before, and sets its implied
/// master: a FlyingShear or a CutListSpec.
SyncSpec read_shear(TomlReader shear, Spec& spec);
/// Reads [indexer].
Indexer read_indexer(TomlReader indexer, const Units& units);

/// Reads the name of a law.
std::optional<Law> read_law(TomlReader& owner, const char* key);
/// Reads the form of a law: inflection, straight, shares.
LawForm read_form(TomlReader& owner);

/// Reads [optimize]; if shapes are free, also [load].
void read_optimize(TomlReader& top, Spec& spec);

/// Reads [load], if it exists.
std::optional<LoadSpec> read_load(TomlReader& top, const Units& units);
/// Reads `free = { shape = ... }` of a segment.
void read_free_shape(TomlReader& free, std::size_t segment, ShapeSpec& shape);
/// Reads the keys of [optimize] for shapes.
void read_shape_optimize(TomlReader& optimize, Spec& spec);
/// Reads `budget`: s, > 0.
std::optional<double> read_budget(TomlReader& optimize);

/// Reads [optimize] with [[optimize.parameter]]. To be called last, after all numbers of the spec
/// have been read.
std::optional<ParametersSpec> read_parameters(TomlReader& top, const Spec& spec);

/// Reads [disc] with [disc.limits], if it exists.
std::optional<DiscPart> read_disc(TomlReader& top, const Units& units);
/// Reads the follower of a disc cam, without its base radius.
DiscPart read_disc_geometry(TomlReader& table, const Units& units);

/// Reads [polydyne], if it exists.
std::optional<Mode> read_polydyne(TomlReader& top);

/// Reads [coupling], whose times are in s.
std::optional<CouplingSpec> read_coupling(TomlReader& top, const Units& units,
                                          const std::string& time_unit);

/// A `profile` of [move], and the function that reads its keys.
struct ProfileReader {
  const char* name;
  MoveSpec (*read)(MotionFields& fields);
};
std::span<const ProfileReader> general_profiles();
std::span<const ProfileReader> controller_profiles();

/// Reads [move], [[knot]], [axis].
MoveSpec read_move(TomlReader move, const Units& units);
/// The target `to` on an axis with this period, as the position in the given direction from the state
/// `from`. An error has the place of `key`. The bounds count only for a state in motion.
double turned_target(TomlReader& move, const char* key, const MotionState& from, double to,
                     Direction direction, double period, const Bounds& bounds = within(1, 1));
/// Reads `direction` of a move; only a modulo axis has one.
Direction read_direction(TomlReader& move, bool modulo);
Table read_knots(TomlReader& top, Spec& spec, Interpolation rule);
AxisSpec read_axis(TomlReader axis, const Units& units);
/// Reads [homing], if it exists.
std::optional<AxisSpec::Homing> read_homing(TomlReader& top, const Units& units);
/// Reads [registration], if it exists.
std::optional<LiveRegistrationSpec> read_registration(TomlReader& top, const Units& units,
                                                      const std::string& master_unit);
/// Reads the correction table of `table`: rule, most, reference, values. `unit`: the unit of the
/// corrected axis; unit_of_reference reads the axis of a reference and returns its unit.
CompensationSpec read_correction_grid(
    TomlReader& table, const std::string& unit,
    const std::function<std::string(TomlReader& reference)>& unit_of_reference);
/// Reads [compensation] of the axis with this name, if it exists.
std::optional<AxisSpec::Compensation> read_axis_compensation(TomlReader& top, const Units& units,
                                                             const std::string& name);
/// Reads [follow], the master of an axis, and in it the table `second`, its second master.
std::optional<FollowWhom> read_whom(TomlReader& owner);
/// Reads [master.NAME]: the masters of a machine.
std::vector<MachineMasterSpec> read_masters(TomlReader& top);

/// Reads [pt], [[point]].
TimeTableSpec read_time_table(TomlReader& top, const Units& units);

/// Reads `outside`: refuse or hold; also wrap or advance, if the motion may repeat; default: hold.
Extrapolation read_outside(TomlReader& reader, bool may_repeat);

/// Throws InputError for another unit, because the rules and ranges of a controller hold in its own
/// units.
void require_unit(const char* key, const std::string& given, const std::string& wanted,
                  const std::string& who);

/// Reads [start], [dynamics], [[command]].
QueueSpec read_queue(TomlReader& top, const Units& units);

/// True for times = "shortest", a key of knots and of points.
bool wants_shortest_times(TomlReader& top);

/// Reads name, unit, [table], [limits] and [drive] of one of several axes. `taken`: names of the
/// others.
AxisPart read_axis_part(TomlReader& axis, const Units& units, std::set<std::string>& taken);

/// Reads [[axis]] into spec.axes; then sync and duration, or [[point]].
AxesSpec read_axes(TomlReader& top, Spec& spec);

/// Reads [[axis]] into spec.axes; then [path], and [[command]], points or [gcode].
PathSpec read_path(TomlReader& top, Spec& spec);

/// Reads [compare] with [compare.device], if it exists.
std::optional<CompareSpec> read_compare(TomlReader& top, const Spec& spec);

/// Reads [[then]].
std::vector<Operator> read_then(TomlReader& top, const Spec& spec);

/// Reads velocity, acceleration, deceleration, jerk, deceleration_jerk. Without `with_velocity`,
/// the caller reads the key `velocity`.
Dynamics read_dynamics(MotionFields& fields, bool with_velocity = true);

/// Reads [table], [limits], and [drive] with [drive.limits] if it exists: of the document, or of
/// one axis. The [table] of a spec that is a table itself (`finished`) has only a rule.
TableOptions read_table_options(TomlReader& owner, const Units& units, bool finished = false,
                                Domain axis = Domain::time);
/// Reads the keys of [table] that request the fewest knots.
void read_target(TomlReader& table, const Units& units, Domain axis, TableOptions& options);
Limits read_limits(TomlReader& owner, const Units& units);
/// Reads [limits] of a cam, per master unit, and [limits.slave], over time.
Limits read_limits(TomlReader& owner, const Units& units, Limits* slave,
                   const std::string& time_unit);
std::optional<DriveSpec> read_drive(TomlReader& owner, const Units& units);
/// Reads [drive.tolerances] of a drive that was read before.
std::optional<ToleranceSpec> read_tolerances(TomlReader& drive_table, const Drive& drive);
/// Reads [follower] with [follower.limits], after the [master].
std::optional<FollowerSpec> read_follower(TomlReader& top, const Spec& spec);

/// Reads [switches], [[switch]] and [[track]]. `of`: the axis of their positions, if the spec does
/// not name it. `master_period`: period of a master that repeats.
AxisSwitches read_switches(TomlReader& top, const Spec& spec, SwitchesOf of,
                           std::optional<double> master_period = {});

/// The units that a key permits.
struct UnitRule {
  bool (*fits)(const std::string& unit);
  const char* text;  ///< rule of the error for another unit
};

/// Reads a unit of measure under `key`.
std::string read_unit(TomlReader& reader, const char* key, const char* fallback,
                      const UnitRule& rule);

/// Reads a unit of time; by default s.
std::string read_time_unit(TomlReader& reader, const char* key);

/// Reads a unit of a position: of length, of angle, or pulses.
std::string read_position_unit(TomlReader& reader, const char* key, const char* fallback);

/// A unit of a master: the same, or of time for a virtual one.
std::string read_master_unit(TomlReader& reader, const char* key);

}  // namespace jounce::spec_detail
