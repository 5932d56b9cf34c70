// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "jounce/axis/command.hpp"
#include "jounce/axis/detail/group_program.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/axis/job.hpp"
#include "jounce/axis/live_cam.hpp"
#include "jounce/axis/master.hpp"
#include "jounce/axis/tick.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/executor/detail/queues.hpp"
#include "jounce/executor/detail/recorded_output.hpp"

namespace jounce {

/// The record of an executor, from its start to its end (a *run*): a sequence of events in
/// chronological order. A record is an LCM log: `lcm-logplayer` plays it, `lcm-spy` shows it with
/// the types of executor/lcm, and docs/executor/replay.md describes it for users. The only time in
/// a record is the tick: the time stamp of an event is tick * period in us, independent of any
/// clock.
///
/// Indices of axes and masters count from 0. Units: u is the unit of the axis, m the unit of its
/// master.

/// Configuration of an axis. This event precedes all other events of the axis.
struct RecordedAxis {
  std::size_t axis = 0;    ///< index of the axis
  std::string name = {};   ///< name of the axis
  Units units = {};        ///< units of the master (x) and of the position
  AxisConfig config = {};  ///< its configuration
  bool whole = true;       ///< false: a black box, which begins in the middle of a run
  /// True: the axis has outputs that are not in the record, so a replay is not possible.
  bool switches = false;
  AxisSwitches outputs = {};  ///< its cam switches; recorded as RecordedOutput events
  AxisCompare compare = {};   ///< its position compare; recorded as RecordedOutput events
};

/// A table, or a part of a large table. An event has at most 200 knots.
struct RecordedTable {
  Sha256 hash{};                                ///< hash of the whole table
  Units units = {};                             ///< units of the table
  Domain over = Domain::time;                   ///< variable of the table
  Interpolation rule = Interpolation::linear;   ///< interpolation rule
  Extrapolation outside = Extrapolation::hold;  ///< policy outside the table
  std::size_t knots = 0;                        ///< number of knots of the whole table
  std::size_t first = 0;                        ///< index of the first knot of this part
  Columns columns = {};                         ///< columns of this part
};

/// The arguments of a Job, a LiveCam or a LiveCuts. Hashes identify the tables.
struct RecordedJob {
  std::size_t axis = 0;            ///< index of the axis
  std::uint64_t id = 0;            ///< id of the movement
  Sha256 time{};                   ///< hash of the table over time; for a live cam, of the cam
  std::optional<Sha256> cam = {};  ///< hash of the cam over a virtual master; nullopt: none
  bool live = false;               ///< true: a cam that follows the live master of the axis
  bool cuts = false;               ///< true, with live: a plan of cuts; `time` has its numbers
  double tick = 1e-3;              ///< length of a tick, s
  CouplingSpec coupling = {};      ///< coupling of the cam
  double position = 0;             ///< position of the slave at the start, u
  CamEnd end = CamEnd::brake;      ///< behavior at the end of a live cam
};

/// The arguments from which the movement of a gear is made.
struct RecordedGear {
  std::size_t axis = 0;                    ///< index of the axis
  std::uint64_t id = 0;                    ///< id of the movement
  ClientCommand gear = command::GearIn{};  ///< the command: GearIn, GearInPos, CombineAxes
  double position = 0;                     ///< position of the slave, u
};

/// A queue that was opened: the fields of the message that define its movement.
struct RecordedQueue {
  std::size_t axis = 0;    ///< index of the axis
  std::uint64_t id = 0;    ///< id of the movement
  wire::Queue queue = {};  ///< the message that opened the queue
};

/// A part of the program of a group: numbers of its timing law (15 for each interval: the fields of
/// LawInterval, in their order). The first part also has the limits and peaks of the axes. A record
/// does not contain the paths of the axes, because the ticks of each axis contain its setpoints.
struct RecordedProgram {
  std::size_t axis = 0;               ///< index of the group
  std::uint64_t id = 0;               ///< id of the movement
  std::size_t total = 0;              ///< intervals of the whole law
  std::size_t first = 0;              ///< index of the first interval of this part
  std::vector<LawInterval> law = {};  ///< intervals of this part; at most 32
  std::vector<GroupAxis> axes = {};   ///< the axes; at most 9
};
/// Returns the parts of a program.
std::vector<RecordedProgram> recorded(const GroupProgram& program, std::size_t axis,
                                      std::uint64_t id);
/// A part of the outputs that the path of a group switches. These events precede the
/// RecordedProgram events of the path.
struct RecordedPathSwitches {
  static constexpr std::size_t most = 32;  ///< greatest number of switches in a part
  std::size_t axis = 0;                    ///< index of the group
  std::uint64_t id = 0;                    ///< id of the movement
  std::vector<PathSwitch> some = {};       ///< 1 to `most`
};
/// Returns the parts of the outputs of a program.
std::vector<RecordedPathSwitches> recorded_switches(const GroupProgram& program, std::size_t axis,
                                                    std::uint64_t id);

/// Returns the program of a group with a straight path of the same length, for a replay of its
/// ticks.
GroupProgram remade(const std::vector<LawInterval>& law, std::vector<GroupAxis> axes);

/// Rows that were added to a queue, or another change of the queue. If many rows were added at
/// once, they are recorded as several events.
struct RecordedRows {
  std::size_t axis = 0;  ///< index of the axis
  HandedOver what = {};  ///< the change
};

/// One axis in one tick: its command, inputs and outputs. Two members of `tick` are empty: the
/// edges of the cam switches, and the returned movements.
struct RecordedCycle {
  std::size_t axis = 0;        ///< index of the axis
  Command command = {};        ///< command of the tick
  std::uint64_t movement = 0;  ///< id of the movement of the command; 0: none
  Inputs inputs = {};          ///< inputs of the tick
  Tick tick = {};              ///< outputs of the tick
};

/// A master of the machine at the start of the run. This event follows the axes.
struct RecordedMaster {
  std::size_t master = 0;       ///< index of the master
  std::string name = {};        ///< name of the master
  std::string unit = {};        ///< unit of its position
  std::uint64_t followers = 0;  ///< bit i: axis i follows the master
  /// Source of the master.
  enum class Made : std::uint8_t {
    elsewhere,  ///< not in the record: its values are inputs of the replay
    samples,    ///< an ExternalMaster, which the replay computes from its samples
    readings,   ///< an EncoderMaster, which the replay computes from its readings
  };
  Made made = Made::elsewhere;  ///< source of the master
  TrackerSpec tracker = {};     ///< options of its filter; unused for `elsewhere`
};

/// An input for the next value of a master: a sample or a reading.
struct RecordedSample {
  std::size_t master = 0;    ///< index of the master
  MasterSample sample = {};  ///< the input
};

/// Value of a master in a cycle. This event precedes the cycles of the axes of the same tick.
struct RecordedSight {
  std::size_t master = 0;    ///< index of the master
  MasterReading sight = {};  ///< the value
};

/// Cycles that are missing at this place in the record.
struct RecordedLoss {
  std::int64_t cycles = 0;  ///< number of missing cycles
};

/// The registration of an axis. This event follows the axis, and precedes its cycles.
struct RecordedRegistration {
  std::size_t axis = 0;            ///< index of the axis
  LiveRegistrationSpec spec = {};  ///< the registration
};

/// The trigger inputs of the drive of an axis. This event precedes the cycle in which they changed.
/// The states stay until the next event; the changes count for one cycle.
struct RecordedTriggers {
  std::size_t axis = 0;    ///< index of the axis
  Triggers triggers = {};  ///< the inputs
};

/// The checksum of all events of Jounce before this one. A record has one after the configuration,
/// one before each write to the disk, and one at its end.
struct RecordedCheck {
  Sha256 hash{};  ///< the checksum; executor/lcm/check_t.lcm defines it
};

/// The correction table of an axis, or a part of it: `spec` has the values from `first` on, at most
/// 200. These events follow the axis, and precede its cycles.
struct RecordedCompensation {
  std::size_t axis = 0;        ///< index of the axis
  AxisCompensation spec = {};  ///< the table, with the values of this part
  std::size_t first = 0;       ///< index of the first value of this part
};
/// Returns the table of an axis as parts, in the order for apply().
std::vector<RecordedCompensation> parts_of(std::size_t axis, const AxisCompensation& whole);
/// Adds a part to the table. Returns false while values are missing.
bool apply(const RecordedCompensation& part, std::optional<AxisCompensation>& whole);

/// Inputs and outputs of the compensation of an axis in one tick. This event precedes the cycle of
/// the tick. `referenced` stays until the next event; the other members count for one cycle.
struct RecordedReferences {
  std::size_t axis = 0;      ///< index of the axis
  bool referenced = false;   ///< Inputs::referenced
  References references{};   ///< Inputs::references
  bool compensated = false;  ///< Tick::compensated
  Jet correction{};          ///< Tick::correction
};

/// Any event of a record.
using RecordEvent =
    std::variant<RecordedAxis, RecordedTable, RecordedJob, RecordedCycle, RecordedLoss,
                 RecordedQueue, RecordedRows, RecordedGear, RecordedMaster, RecordedSight,
                 RecordedOutput, RecordedSample, RecordedProgram, RecordedRegistration,
                 RecordedTriggers, RecordedCheck, RecordedCompensation, RecordedReferences,
                 RecordedPathSwitches>;

/// Returns the channel of an event: "JOUNCE.cycle", ...
std::string_view channel_of(const RecordEvent& event);
/// Returns the bytes of an event in the encoding of LCM.
std::string encoded(const RecordEvent& event);
/// Returns the checksum of a record after one more event of Jounce: SHA-256(check, channel, 0,
/// bytes). The checksum of no event is 0. Numbers and time stamps of the events are not included.
Sha256 continued(const Sha256& check, std::string_view channel, std::string_view bytes);
/// Decodes an event. Returns nullopt for a channel of another program. Throws InputError for bytes
/// that are not an event of this channel.
std::optional<RecordEvent> decoded(std::string_view channel, std::string_view bytes);

/// A field in which a recorded and a replayed tick differ, even by the last bit.
struct TickDifference {
  std::string field = {};  ///< name of the field as in cycle_t: "position", "state", ...
  double recorded = 0;     ///< value in the record
  double replayed = 0;     ///< value of the replay
};
/// Returns the first difference, in the order of the fields of cycle_t; nullopt if the ticks are
/// identical. If `switches` is true, also compares the outputs and the instants of their edges.
std::optional<TickDifference> first_difference(const Tick& recorded, const Tick& replayed,
                                               bool switches = true);

}  // namespace jounce
