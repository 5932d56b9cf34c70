// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/cam/coupling/coupling.hpp"
#include "jounce/command/state.hpp"
#include "jounce/pvt/table.hpp"
#include "jounce/stream/message/command.hpp"
#include "jounce/stream/message/queue.hpp"

/// The messages of version 2 of the stream protocol, as values. docs/stream-protocol.md defines who
/// sends them, and in which order. stream/lcm/*.lcm defines their layout on the wire; wire.hpp
/// converts between the values and the bytes.
namespace jounce::wire {

/// Version of the protocol, contained in each message.
inline constexpr std::int32_t protocol_version = 2;
/// Greatest number of doubles in a chunk, which is sent as one datagram.
inline constexpr std::size_t chunk_values = 7680;
/// Doubles in a message of 12.8 KB. A receiver is configured with a credit: the number of messages
/// of this size that may be in transit. Ack::credit is the same limit as a number of chunks.
inline constexpr std::size_t message_values = 1600;
/// Doubles of buffer space for each message of credit.
inline constexpr std::size_t credit_values = 2048;
/// Length of a name (Message::executor), with a final zero, bytes.
inline constexpr std::size_t executor_bytes = 24;
inline constexpr std::size_t unit_bytes = 16;  ///< length of a unit, with a final zero, bytes
/// Length of a reason as text, with a final zero, bytes.
inline constexpr std::size_t reason_bytes = 160;
inline constexpr std::uint32_t most_tables = 64;  ///< greatest number of tables in a session

/// The motion that an axis plays, and the master that it follows.
enum class ArmMode : std::int8_t {
  play = 0,          ///< a table over time
  follow_input = 1,  ///< a table over a master; the master is the live master of the axis
  follow_table = 2,  ///< a table over a master; the master is virtual: a second table over time
  queue = 3,         ///< no table: a queue, which accepts rows during the motion
  /// The path of a group: a program as a table of numbers (jounce/path/program_numbers.hpp) over
  /// their index.
  path = 4,
};

/// Kind of a stop.
enum class StopMode : std::int8_t {
  stop = 0,   ///< a stop with the configured deceleration and jerk
  abort = 1,  ///< the fastest stop of the axis
};

/// Reason why the executor rejects a message; name(Refusal) returns the name of the reason.
enum class Refusal : std::int8_t {
  none = 0,         ///< accepted
  busy = 1,         ///< another program owns the axis in its session
  unknown_session,  ///< no message has opened this session: the executor may have restarted
  /// The session was released, has timed out, or was ended by a stop of an operator.
  session_ended,
  bad_header,  ///< the header is inconsistent, or differs from an earlier one with the same index
  too_large,   ///< the table has more knots, or the queue more rows, than the executor permits
  out_of_memory,  ///< the executor's memory for tables is full, or too many queues are open
  bad_chunk,      ///< a chunk does not match the header of its table
  hash_mismatch,  ///< all chunks have arrived, but the table differs from the announced one
  bad_table,      ///< the table is invalid: see the reason
  table_missing,  ///< the table to be armed has not arrived completely
  wrong_axis,     ///< a table over time where a table over a master is required, or the reverse
  wrong_unit,     ///< a table or queue over time that is not in s, or a master in another unit
  not_armed,      ///< a start, but nothing is armed
  axis,           ///< rejected by the axis: see the reason
  /// The message does not contain the newest challenge of the executor. The reply contains it.
  stale_challenge,
  bad_queue,      ///< the queue is inconsistent, or differs from an earlier one with the same index
  bad_rows,       ///< rows do not match their queue, or earlier rows
  bad_row,        ///< a row breaks a limit, or is not continuous: see row and reason
  queue_missing,  ///< the queue is not open, or was rejected
  prefill_missing,  ///< the queue has fewer rows than it needs for a start
  bad_order,        ///< a value of a command is out of its range
};
inline constexpr int refusals = 22;  ///< number of refusals

/// Outcome of a start that the axis has accepted. A start that waits is checked again when it takes
/// place.
enum class StartOutcome : std::int8_t {
  none = 0,     ///< no start was accepted in this session
  waiting = 1,  ///< waits for its tick, its master position, or the end of the present motion
  begun = 2,    ///< the motion has begun
  dropped = 3,  ///< the motion did not begin: see start_reason
};

/// Outcome of a command.
enum class Outcome : std::int8_t { pending = 0, accepted = 1, refused = 2 };

/// Progress of a motion.
enum class Progress : std::int8_t {
  none = 0,      ///< no motion
  waiting = 1,   ///< waits for its master or an event
  engaging = 2,  ///< approaches its coupled position: ramp, clutch
  running = 3,   ///< a path is played, or the slave is in step
  starving = 4,  ///< buffer underrun: the available rows end
  done = 5,      ///< has reached its end
  broken = 6,    ///< could not continue
};

/// Next action of an axis, after the present motion.
enum class Next : std::int8_t {
  nothing = 0,
  armed = 1,    ///< a motion is armed and waits for a start
  waiting = 2,  ///< a start was accepted and waits for its tick
};

// ---- from the streamer -------------------------------------------------------------------------

/// Announces a table. A Header can open a session, and so can a Queue or a Heartbeat.
struct Header {
  std::uint32_t table = 0;     ///< index of the table in the session, 0 to 63
  Sha256 hash{};               ///< content_hash(table, units); zeros: the hash follows in a later
                               ///< header
  Domain axis = Domain::time;  ///< variable of the table
  Interpolation rule = Interpolation::linear;     ///< interpolation rule
  Extrapolation outside = Extrapolation::refuse;  ///< policy outside the table
  Units units = {};                               ///< units of x and of the position
  std::uint32_t knots = 0;                        ///< number of knots, >= 2
  std::uint32_t columns = 0;    ///< number of columns, 2 to 4, depending on the rule
  std::uint32_t per_chunk = 0;  ///< knots in a full chunk, 1 to chunk_values / columns
  std::uint32_t chunks = 0;     ///< number of chunks: ceil(knots / per_chunk)

  /// True if the header contains the hash.
  [[nodiscard]] bool has_hash() const { return hash != Sha256{}; }
};

/// Some knots of a table, column after column: x of all these knots, then p of all, ...
struct Chunk {
  std::uint32_t table = 0;       ///< index of the table
  std::uint32_t seq = 0;         ///< number of the chunk, 0 to chunks - 1
  std::uint32_t first_knot = 0;  ///< index of its first knot: seq * per_chunk
  std::uint32_t knots = 0;       ///< number of knots; full, except for the last chunk
  std::uint32_t columns = 0;     ///< number of columns
  std::vector<double> values{};  ///< knots * columns values, at most chunk_values
};

/// Arms a motion.
///
/// The commands of a session have ascending numbers, from 1. If a number is repeated, the executor
/// repeats the recorded outcome. A command with a lower number is ignored, so that a late start
/// cannot follow a stop.
struct Arm {
  std::int32_t command = 0;      ///< number of the command
  ArmMode mode = ArmMode::play;  ///< the motion that the axis plays
  Sha256 slave{};                ///< hash of the slave's table
  Sha256 master{};               ///< hash of the master's table; zeros except for follow_table
  /// Coupling of a slave's table over a master. Its member master_jump is not transmitted.
  CouplingSpec coupling{};
  std::uint32_t queue = 0;     ///< for ArmMode::queue: index of the queue, 64 to 127
  std::uint8_t bank = 0;       ///< for a static queue: the bank that is played first
  CamEnd end = CamEnd::brake;  ///< for follow_input: behavior at the end of the cam
};

/// Starts the armed motion.
struct Start {
  std::int32_t command = 0;      ///< number of the command
  std::int64_t tick = -1;        ///< tick of the start; -1: the next one
  StartAt when = StartAt::tick;  ///< condition of the start
  /// Master position of the start, m (unit of the master), for master_position.
  double position = 0;
};

/// Stops the axis. In session 0, it is the stop of an operator, which also ends the session of the
/// axis.
struct Stop {
  std::int32_t command = 0;        ///< number of the command
  StopMode mode = StopMode::stop;  ///< kind of the stop
};

/// Keeps a session alive, or ends it. A motion continues when its session ends.
struct Heartbeat {
  std::int32_t command = 0;  ///< number of the command
  bool release = false;      ///< true: ends the session
};

// ---- from the executor -------------------------------------------------------------------------

/// Acknowledges the chunks of a table.
struct Ack {
  std::int64_t boot = 0;     ///< random number of this start of the executor
  std::uint32_t table = 0;   ///< index of the table in the session
  std::uint32_t next = 0;    ///< all chunks below this number have arrived
  std::uint64_t mask = 0;    ///< bit i: chunk next + 1 + i has arrived
  std::uint32_t credit = 0;  ///< number of chunks, from `next` on, that may be in transit
  bool complete = false;     ///< true: the table is complete, its hash matches, and the executor
                             ///< has stored it
  Refusal refusal = Refusal::none;  ///< reason why the table is rejected
  std::string reason{};             ///< the reason as text; may be empty
};

/// Answers a command.
struct Reply {
  std::int64_t boot = 0;               ///< see Ack
  std::int32_t command = 0;            ///< number of the command
  Outcome outcome = Outcome::pending;  ///< outcome of the command
  Refusal refusal = Refusal::none;     ///< reason for rejecting the command
  /// Number of the Cause: for Refusal::axis; for Refusal::session_ended, Cause::stopped if the axis was
  /// stopped with the session. 0: none.
  std::int32_t cause = 0;
  /// The reason as text, or a remark on an accepted command; may be empty.
  std::string reason{};
};

/// Acknowledges the rows of a queue. Arrays have one entry for each of the two banks.
struct QueueAck {
  std::int64_t boot = 0;              ///< see Ack
  std::uint32_t queue = first_queue;  ///< index of the queue
  /// All messages of rows with a number below this one have been accepted.
  std::array<std::uint32_t, 2> next{};
  std::array<std::uint64_t, 2> mask{};   ///< bit i: message next + 1 + i has arrived
  std::array<std::uint32_t, 2> space{};  ///< free rows after the rows of the messages below `next`
  std::int64_t played = 0;  ///< number of rows that were played since the queue was opened
  Progress progress = Progress::none;  ///< progress of the motion
  Refusal refusal = Refusal::none;     ///< reason for rejecting the queue; permanent
  std::int64_t row = -1;               ///< index of the rejected row in its bank, from 0; -1: none
  std::string reason{};                ///< the reason as text; may be empty
};

/// A histogram of durations. Class 0 counts durations below 1 us, class i (1 to 14) durations from
/// 2^(i-1) us to below 2^i us, class 15 all others.
using Histogram = std::array<std::int32_t, 16>;

/// Bits of Status::unwritten: files that the executor could not create, or could not continue to
/// its end.
enum Unwritten : std::uint8_t { log_unwritten = 1, record_unwritten = 2, black_box_unwritten = 4 };

/// State of the pair of an axis and its live master (HMPL manual, chapter 6). The numbers are part
/// of the wire format.
enum class GearState : std::int8_t {
  none = 0,        ///< the axis has no master
  disengaged = 1,  ///< the axis has a master, and does not follow it
  engaging = 2,    ///< the axis engages: a ramp, a clutch, or it waits for its sync position
  in_gear = 3,     ///< the axis follows its master at the ratio
  in_cam = 4,      ///< the axis follows its master by a cam, a follow table or a plan of cuts
};

/// Status of an axis, sent every few milliseconds. Only the newest status is valid.
struct Status {
  State state = State::disabled;  ///< state of the axis
  Next next = Next::nothing;      ///< next action of the axis
  std::int64_t tick = 0;          ///< number of the tick
  std::int64_t cycle_ns = 1;      ///< duration of a tick, ns, > 0
  double master_position = 0;     ///< position of the master, in its unit; NaN: no master
  double slave_position = 0;      ///< commanded position, in the unit of the axis
  double slave_velocity = 0;      ///< commanded velocity, in the unit of the axis per s
  /// First bytes of the hash of the slave's table; zeros: none.
  std::array<std::uint8_t, 8> table{};
  std::int32_t last_error = 0;  ///< number of the Cause of the fault; 0: no fault
  /// Number of cycles that began too late, since the executor started.
  std::int64_t late_ticks = 0;
  /// Number of motions that reached their end, since the executor started.
  std::int64_t finished = 0;
  /// Number of motions that a stop brought to rest, since the executor started.
  std::int64_t stopped = 0;
  double actual_position = unknown;    ///< actual position of the drive; NaN: unknown
  double following_error = unknown;    ///< commanded minus actual position; NaN: unknown
  double torque = unknown;             ///< share of the rated torque; NaN: unknown
  double override_ = 1;                ///< override factor
  Progress progress = Progress::none;  ///< progress of the motion
  std::int32_t reason = 0;       ///< number of the Cause that ended the last motion early; 0: none
  std::uint32_t queue_rows = 0;  ///< rows that wait in the armed or active queue
  std::uint32_t queue_capacity = 0;  ///< capacity of this queue in rows
  std::uint32_t outputs = 0;         ///< cam switches that are on; bit 0 is track 1
  std::int64_t boot = 0;             ///< see Ack
  /// Number of packets that were not valid messages, since the executor started.
  std::int64_t rejected = 0;
  /// Number of these packets whose authentication code (mac) was wrong.
  std::int64_t not_authentic = 0;
  Histogram lateness{};                     ///< delays of the starts of the cycles
  Histogram computing{};                    ///< computing times of the cycles
  Units units{};                            ///< units of the axis; empty: any
  std::int32_t start_command = 0;           ///< number of the last start of this session; 0: none
  StartOutcome start = StartOutcome::none;  ///< outcome of this start
  std::int32_t start_cause = 0;      ///< number of the Cause for which it was dropped; 0: none
  std::string start_reason{};        ///< the reason as text
  bool held = false;                 ///< true if a motion is held until the command resume
  bool homed = false;                ///< true if the axis was homed
  std::uint8_t unwritten = 0;        ///< files that could not be written, see Unwritten
  GearState gear = GearState::none;  ///< state of the gear pair of the axis with its master
  bool gear_master = false;          ///< true if another axis has this axis as its master
  double ratio = 0;                  ///< ratio of the gear, u/m; 0: no gear
  double correction = unknown;       ///< correction of the compensation, u; NaN: not active

  /// Value of an unknown number: NaN.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
};

/// Kind of an event.
enum class EventKind : std::int8_t {
  compare = 0,  ///< the output of the position compare
  track = 1,    ///< a cam switch; `number`: its track
  tappet = 2,   ///< an output of another executor
  probe = 3,    ///< a capture of a touch probe; `number`: its input, `on`: rising edge
  mark = 4,     ///< registration; `number`: see MarkEvent
  /// A pass of a cam or a follow table on the live master has ended; `number`: number of passes
  /// that have ended; `position`: position of the master.
  end_of_profile = 5,
  /// A follow table begins; `number`: its bank, 1 or 2; `position`: position of the master.
  table_begin = 6,
  m_word = 7,  ///< M word `number` of a group; `on`: it waits for its acknowledgment
};

/// Number of an event of the registration.
enum class MarkEvent : std::uint32_t {
  accepted = 1,  ///< a mark in its window; `position`: its deviation
  missing = 2,   ///< a product without a mark
  stray = 3,     ///< a mark outside its window
  lost = 4,      ///< too many missing marks in succession
};

/// An event at an instant between two ticks. The message may be sent several times, with the same
/// count.
struct Event {
  std::int64_t boot = 0;  ///< see Ack
  /// Number of the event for this axis, from 1, since the executor started.
  std::int64_t count = 0;
  EventKind kind = EventKind::compare;  ///< kind of the event
  std::uint32_t number = 1;             ///< number of the output or input, from 1
  bool on = false;                      ///< true: the output was switched on; see EventKind
  std::int64_t tick = 0;                ///< tick in which it was detected
  double offset_s = 0;                  ///< time from the edge to the instant of this tick, s, >= 0
  /// Position at the edge, of the axis or master on which the output depends, in its unit.
  double position = 0;
};

// ---- from a master -----------------------------------------------------------------------------

/// Position of an external master. Message::executor contains the name of the master.
struct Master {
  std::int64_t seq = 0;  ///< number of the message, >= 0, ascending
  /// Time of the measurement by the clock of the sender, ns, >= 0, ascending.
  std::int64_t stamp_ns = 0;
  /// Number of the sender's clock. It increases when the clock is changed or restarted.
  std::int32_t clock = 0;
  bool valid = false;                 ///< false: the master is lost, or its position is unknown
  double position = 0;                ///< position, finite
  double velocity = Status::unknown;  ///< velocity per second; NaN: unknown
  std::string unit{};                 ///< unit of the position; not empty
};

/// State of a master in an executor. Message::executor is the name of an axis that follows the
/// master, or of the machine's first axis.
struct MasterStatus {
  std::int64_t boot = 0;  ///< see Ack
  std::string master{};   ///< name of the master
  std::string unit{};     ///< unit of the position; not empty
  std::int64_t tick = 0;  ///< tick of these values
  bool lost = true;       ///< true: there is no master now, and position and velocity are NaN
  double position = Status::unknown;  ///< position
  double velocity = Status::unknown;  ///< velocity, per second
  /// Age of the measurement, s; NaN: no measurement; 0: the position is computed.
  double age_s = Status::unknown;
  std::int64_t taken = 0;    ///< number of accepted samples from the link
  std::int64_t refused = 0;  ///< number of rejected samples: old, repeated, or in another unit
};

/// Place of a group on its path, sent with the Status of the group. u is the unit of its axes.
struct GroupStatus {
  /// Greatest number of axes of a group.
  static constexpr std::size_t most_axes = 9;

  std::int64_t boot = 0;  ///< see Ack
  std::int64_t tick = 0;  ///< tick of these values
  /// Names of the coordinates in commands: the axes of the group, or the axes of its tool.
  std::vector<std::string> axes{};
  /// Commanded coordinates, in the frame of the commands, one for each name; NaN: unknown.
  std::vector<double> place{};
  bool framed = false;              ///< true: the commands have a frame
  std::int32_t line = 0;            ///< source line of the present command, or the number of a
                                    ///< single command; 0: no path
  std::uint32_t commands = 0;       ///< number of commands that have not ended
  bool estimated = false;           ///< true: `remaining_s` is an estimate
  double position = 0;              ///< length along the path from its start, u
  double length = Status::unknown;  ///< length of the path as planned now, u; NaN: no path
  double feed = 0;                  ///< velocity along the path, u/s
  /// Time to the end of the path, s; NaN: no path, or unknown. Exact if the path is played at its
  /// original speed.
  double remaining_s = Status::unknown;
  /// Distance to the place where the group brakes for the end of its path, u; NaN: no path.
  double look_ahead = Status::unknown;
  /// Units of the coordinates, one for each name; no entries, or "": unknown.
  std::vector<std::string> units{};
};

// ---- between executors --------------------------------------------------------------------------

/// An executor claims, or already owns, the name in Message::executor.
struct Claim {
  std::int64_t boot = 0;  ///< see Ack
  /// Boot of the executor that this message answers; 0: a request to all executors.
  std::int64_t rival = 0;
  bool up = false;  ///< true: the executor accepts commands; false: it is starting
};

/// Any content of a message.
using Body = std::variant<Header, Chunk, Arm, Start, Stop, Heartbeat, Ack, Reply, Status, Command,
                          Queue, Rows, QueueAck, Master, Event, MasterStatus, Claim, GroupStatus>;

/// A message of the protocol.
struct Message {
  std::string executor =
      {};  ///< Name of the axis of an executor: 1 to 23 of the characters A-Z a-z 0-9
           ///< _ -. In a Master: name of the master.
  /// Session, > 0; 0: no session (a Status of a free axis, a message of an operator, Master, Event,
  /// MasterStatus, GroupStatus, Claim).
  std::int64_t session = 0;
  Body body = {};  ///< the content
  /// From an executor: the challenge that commands must contain. To an executor: the challenge that
  /// the sender received last, 0 at first. See Receiver.
  std::int64_t challenge = 0;
};

/// Returns the name of an enumerator: "follow_input", ...
const char* name(ArmMode mode);
const char* name(Refusal refusal);
const char* name(Next next);
const char* name(Progress progress);
const char* name(EventKind kind);
const char* name(GearState gear);

/// The chunks of a table.
struct Cut {
  std::uint32_t columns = 0;    ///< 2, 3 or 4, depending on the rule
  std::uint32_t per_chunk = 0;  ///< knots of a full chunk
  std::uint32_t chunks = 0;     ///< number of chunks

  /// Returns the number of knots in chunk `seq` of a table with this number of knots.
  [[nodiscard]] std::uint32_t knots_of(std::uint32_t seq, std::uint32_t knots) const;
  /// Returns the number of chunks that a credit of this number of messages permits in transit, at
  /// least 1. A chunk of more than credit_values doubles uses the buffer space of more than one
  /// message.
  [[nodiscard]] std::uint32_t chunks_for(std::uint32_t messages) const;
};
/// Divides a table into chunks. `values`: doubles in a full chunk, 4 to chunk_values.
Cut cut(Interpolation rule, std::uint32_t knots, std::size_t values = message_values);
/// Returns the division that the sender of this header uses. Requires per_chunk >= 1.
Cut cut(const Header& header);

/// True if the text is a valid name of an executor.
bool is_executor_name(std::string_view name);
/// The rule of is_executor_name(), for error messages.
inline constexpr const char* executor_name_rule =
    "must have 1 to 23 characters, each a letter A-Z or a-z, a digit, _ or -";

}  // namespace jounce::wire
