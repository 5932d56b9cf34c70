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

/// The messages of stream protocol version 2, as values. docs/stream-protocol.md defines sender and
/// time of each; stream/lcm/*.lcm is their layout on the wire; wire.hpp converts between both.
namespace jounce::wire {

inline constexpr std::int32_t protocol_version = 2;
inline constexpr std::size_t chunk_values = 7680;    ///< doubles of a chunk, at most: one datagram
inline constexpr std::size_t message_values = 1600;  ///< doubles of a message, the unit of credit
inline constexpr std::size_t credit_values = 2048;   ///< doubles of space for one message of credit
inline constexpr std::size_t executor_bytes =
    24;                                        ///< bytes of an executor's name, final zero included
inline constexpr std::size_t unit_bytes = 16;  ///< bytes of a unit, final zero included
inline constexpr std::size_t reason_bytes =
    160;  ///< bytes of a reason in words, final zero included
inline constexpr std::uint32_t most_tables = 64;  ///< tables of one session, at most

/// Drive of the slave.
enum class ArmMode : std::int8_t {
  play = 0,          ///< the slave table is over time
  follow_input = 1,  ///< the slave table is over master and follows the executor's master input
  follow_table = 2,  ///< the slave table is over master and follows a master table over time
  queue = 3,         ///< no table: a queue, which accepts rows during the motion
};

enum class StopMode : std::int8_t {
  stop = 0,   ///< a jerk-limited stop, as configured
  abort = 1,  ///< the fastest stop of the axis
};

/// Reason why the executor rejects a message; 0: accepted. name(Refusal) has the words.
enum class Refusal : std::int8_t {
  none = 0,
  busy = 1,         ///< the axis belongs to another live session
  unknown_session,  ///< no header opened this session: the executor has restarted
  session_ended,    ///< this session was released, timed out, or was ended by an operator's stop
  bad_header,       ///< the header contradicts itself, or an earlier one with the same index
  too_large,        ///< more knots than the executor permits
  out_of_memory,    ///< the executor's memory for tables is full
  bad_chunk,        ///< a chunk contradicts its header
  hash_mismatch,    ///< every chunk arrived, but the table differs from the announced one
  bad_table,        ///< the announced table is invalid: see the reason
  table_missing,    ///< the table to arm has not arrived completely
  wrong_axis,       ///< a table over time instead of one over master, or the reverse
  wrong_unit,       ///< a table over time not in s, or a master in another unit
  not_armed,        ///< start without arm
  axis,             ///< rejected by the axis: see the reason
  stale_challenge,  ///< it does not carry the executor's newest challenge; the answer has it
  bad_queue,        ///< the queue contradicts itself, or an earlier one with the same index
  bad_rows,         ///< rows contradict their queue, or earlier rows
  bad_row,          ///< a row would violate a limit, or leave the path: see row and reason
  queue_missing,    ///< the requested queue is not open
  prefill_missing,  ///< the queue has fewer rows than its prefill
  bad_order,        ///< a value of a command is out of its range
};
inline constexpr int refusals = 22;

/// Outcome of an accepted start: a later start is checked when it takes place.
enum class StartOutcome : std::int8_t {
  none = 0,     ///< no start was accepted in this session
  waiting = 1,  ///< for its tick, its master position, or the end of the active motion
  begun = 2,
  dropped = 3,  ///< it did not begin: see start_reason
};

/// Progress of a command.
enum class Outcome : std::int8_t { pending = 0, accepted = 1, refused = 2 };

/// Progress of the motion.
enum class Progress : std::int8_t {
  none = 0,      ///< no motion
  waiting = 1,   ///< for its master, or an event
  engaging = 2,  ///< approaches its coupled position: ramp, clutch
  running = 3,
  starving = 4,  ///< buffer underrun: the available rows end
  done = 5,
  broken = 6,  ///< it could not continue
};

/// Its next action.
enum class Next : std::int8_t {
  nothing = 0,
  armed = 1,    ///< a table waits for its start
  waiting = 2,  ///< the start waits for its tick
};

// ---- from the streamer -------------------------------------------------------------------------

/// Announces a table; the first header of a session opens it.
struct Header {
  std::uint32_t table = 0;  ///< index within the session, 0...63
  Sha256 hash{};            ///< content_hash(table, units); zeros: it follows later
  Domain axis = Domain::time;
  Interpolation rule = Interpolation::linear;
  Extrapolation outside = Extrapolation::refuse;
  Units units;
  std::uint32_t knots = 0;      ///< >= 2
  std::uint32_t columns = 0;    ///< 2...4, depending on the rule
  std::uint32_t per_chunk = 0;  ///< knots of a full chunk, 1...chunk_values / columns
  std::uint32_t chunks = 0;     ///< ceil(knots / per_chunk)

  [[nodiscard]] bool has_hash() const { return hash != Sha256{}; }
};

/// Some knots, column after column: x of all, then p of all, ...
struct Chunk {
  std::uint32_t table = 0;
  std::uint32_t seq = 0;         ///< 0...chunks - 1
  std::uint32_t first_knot = 0;  ///< seq * per_chunk
  std::uint32_t knots = 0;       ///< full except for the last chunk
  std::uint32_t columns = 0;
  std::vector<double> values{};  ///< knots * columns <= chunk_values
};

/// Commands are numbered within a session, from 1, ascending. The answer to a repeated number is
/// its recorded outcome; a number lower than the last is ignored. A late start can therefore not
/// cancel a stop.
struct Arm {
  std::int32_t command = 0;
  ArmMode mode = ArmMode::play;
  Sha256 slave{};              ///< hash of the slave table
  Sha256 master{};             ///< hash of the master table; zero unless mode is follow_table
  CouplingSpec coupling{};     ///< coupling of a slave table over master; without master_jump
  std::uint32_t queue = 0;     ///< for mode queue: 64...127
  std::uint8_t bank = 0;       ///< bank of a static queue: the bank that begins
  CamEnd end = CamEnd::brake;  ///< for follow_input
};

struct Start {
  std::int32_t command = 0;
  std::int64_t tick = -1;  ///< start tick of the executor; -1: the next one
  StartAt when = StartAt::tick;
  double position = 0;  ///< m, with master_position
};

/// Stops the axis. In session 0 it is an operator's stop, and ends the present session.
struct Stop {
  std::int32_t command = 0;
  StopMode mode = StopMode::stop;
};

/// Keeps a session alive, or ends it. A motion continues without its session.
struct Heartbeat {
  std::int32_t command = 0;
  bool release = false;
};

// ---- from the executor -------------------------------------------------------------------------

/// Progress of a table.
struct Ack {
  std::int64_t boot = 0;     ///< random number of each start of the executor
  std::uint32_t table = 0;   ///< index within the session
  std::uint32_t next = 0;    ///< every chunk below has arrived
  std::uint64_t mask = 0;    ///< bit i: chunk next + 1 + i has arrived
  std::uint32_t credit = 0;  ///< chunks from `next` on that may be in transit
  bool complete = false;     ///< the table is complete, its hash matches, and it is stored
  Refusal refusal = Refusal::none;
  std::string reason{};  ///< in words; may be empty
};

/// Progress of a command.
struct Reply {
  std::int64_t boot = 0;
  std::int32_t command = 0;
  Outcome outcome = Outcome::pending;
  Refusal refusal = Refusal::none;
  std::int32_t cause = 0;  ///< the axis's number of the cause
  std::string reason{};
};

/// Progress of a queue. Two numbers: one for each bank.
struct QueueAck {
  std::int64_t boot = 0;
  std::uint32_t queue = first_queue;
  std::array<std::uint32_t, 2> next{};   ///< all messages of rows below it have been taken
  std::array<std::uint64_t, 2> mask{};   ///< bit i: message next + 1 + i has arrived
  std::array<std::uint32_t, 2> space{};  ///< free rows after those of `next`
  std::int64_t played = 0;               ///< rows played to their end since the queue was opened
  Progress progress = Progress::none;
  Refusal refusal = Refusal::none;  ///< final for this queue
  std::int64_t row = -1;            ///< rejected row, from 0 in its bank; -1: none
  std::string reason{};
};

/// Histogram of durations: class i < 15 counts cycles below 2^i us that are in no lower class,
/// class 15 all others.
using Histogram = std::array<std::int32_t, 16>;

/// Bits of Status::unwritten: the file ended before the run, or was never created.
enum Unwritten : std::uint8_t { log_unwritten = 1, record_unwritten = 2, black_box_unwritten = 4 };

/// Status of the axis; published every few milliseconds, only the newest is valid.
struct Status {
  State state = State::disabled;
  Next next = Next::nothing;
  std::int64_t tick = 0;                ///< number of this cycle
  std::int64_t cycle_ns = 1;            ///< length of a cycle, ns, > 0
  double master_position = 0;           ///< the unit of the slave table's x; NaN: no master
  double slave_position = 0;            ///< the unit of the slave table's position
  double slave_velocity = 0;            ///< that unit per second
  std::array<std::uint8_t, 8> table{};  ///< first bytes of the slave table's hash; zeros: none
  std::int32_t last_error = 0;          ///< the axis's number of the error; 0: none
  std::int64_t late_ticks = 0;          ///< cycles that began too late, since the executor started
  std::int64_t finished = 0;            ///< motions since the start that reached their end
  std::int64_t stopped = 0;             ///< motions since the start that a stop brought to rest
  double actual_position = unknown;     ///< actual position of the drive
  double following_error = unknown;     ///< commanded minus actual
  double torque = unknown;              ///< share of the rated torque
  double override_ = 1;                 ///< velocity factor
  Progress progress = Progress::none;   ///< progress of the motion
  std::int32_t reason = 0;              ///< cause of an early end of the last motion; 0: none
  std::uint32_t queue_rows = 0;         ///< rows waiting in the armed or active queue
  std::uint32_t queue_capacity = 0;     ///< rows that this queue can hold
  std::uint32_t outputs = 0;            ///< switches: track 1 is bit 0
  std::int64_t boot = 0;                ///< see Ack
  std::int64_t rejected = 0;            ///< packets since the start that were not messages
  std::int64_t not_authentic = 0;       ///< rejected packets with a wrong mac
  Histogram lateness{};                 ///< lateness of the start of each cycle
  Histogram computing{};                ///< computing time of each cycle
  Units units{};                        ///< units of the axis; empty: any
  std::int32_t start_command = 0;       ///< the last start of this session; 0: none
  StartOutcome start = StartOutcome::none;  ///< its outcome
  std::int32_t start_cause = 0;             ///< reason why it was dropped, like last_error
  std::string start_reason{};               ///< in words
  bool held = false;                        ///< a motion waits for the command resume
  bool homed = false;                       ///< its position refers to its home position
  std::uint8_t unwritten = 0;               ///< files that could not be written: see Unwritten

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
};

enum class EventKind : std::int8_t { compare = 0, track = 1, tappet = 2 };

/// An output has switched. It may be sent several times, with one count.
struct Event {
  std::int64_t boot = 0;
  std::int64_t count = 0;  ///< number of the event for this axis since the executor started, from 1
  EventKind kind = EventKind::compare;
  std::uint32_t number = 1;  ///< number of the output, from 1
  bool on = false;
  std::int64_t tick = 0;  ///< the cycle that detected it
  double offset_s = 0;    ///< s before that cycle's instant, >= 0
  double position = 0;    ///< position of the signal that the output depends on, at that time
};

// ---- from a master -----------------------------------------------------------------------------

/// Position of a master; Message::executor is the name of the master.
struct Master {
  std::int64_t seq = 0;               ///< >= 0, rising
  std::int64_t stamp_ns = 0;          ///< >= 0: measurement time by the sender's clock; ascending
  std::int32_t clock = 0;             ///< a later clock, or epoch of it, has a greater number
  bool valid = false;                 ///< false: it is lost, or its position unknown
  double position = 0;                ///< finite
  double velocity = Status::unknown;  ///< per second; NaN: unknown
  std::string unit{};                 ///< unit of the position; not empty
};

/// State of a master in an executor; Message::executor is an axis that follows it, or the machine's
/// first axis.
struct MasterStatus {
  std::int64_t boot = 0;  ///< see Ack
  std::string master{};   ///< its name, like that of an executor
  std::string unit{};     ///< unit of the position; not empty
  std::int64_t tick = 0;  ///< the cycle of these values
  bool lost = true;       ///< no master, or no longer: position and velocity are NaN
  double position = Status::unknown;
  double velocity = Status::unknown;  ///< per second
  double age_s = Status::unknown;     ///< age of the measurement; NaN: none; 0: computed
  std::int64_t taken = 0;             ///< accepted samples from the bus
  std::int64_t refused = 0;           ///< rejected samples: old, repeated, in another unit
};

// ---- between executors --------------------------------------------------------------------------

/// An executor owns the name Message::executor, or claims it at its start.
struct Claim {
  std::int64_t boot = 0;   ///< see Ack
  std::int64_t rival = 0;  ///< boot of the executor that it answers; 0: a question to all
  bool up = false;         ///< it accepts commands; false: it is starting
};

using Body = std::variant<Header, Chunk, Arm, Start, Stop, Heartbeat, Ack, Reply, Status, Command,
                          Queue, Rows, QueueAck, Master, Event, MasterStatus, Claim>;

struct Message {
  std::string executor;  ///< 1 to 23 of A-Z a-z 0-9 _ -
  std::int64_t session =
      0;  ///< > 0; 0: none (Status of a free axis, an operator, Master, Event, MasterStatus, Claim)
  Body body;
  /// From an executor: the challenge that commands must carry. To it: the last received challenge,
  /// 0 at first.
  std::int64_t challenge = 0;
};

const char* name(ArmMode mode);
const char* name(Refusal refusal);
const char* name(Next next);
const char* name(Progress progress);
const char* name(EventKind kind);

/// Division of a table into chunks.
struct Cut {
  std::uint32_t columns = 0;    ///< 2, 3 or 4, depending on the rule
  std::uint32_t per_chunk = 0;  ///< knots of a full chunk
  std::uint32_t chunks = 0;

  /// Knots of chunk `seq`.
  [[nodiscard]] std::uint32_t knots_of(std::uint32_t seq, std::uint32_t knots) const;
  /// Number of chunks that fit the space of that many messages of message_values. Longer chunks use
  /// at most credit_values per message, but at least 1 chunk is possible.
  [[nodiscard]] std::uint32_t chunks_for(std::uint32_t messages) const;
};
/// `values`: doubles of a full chunk, 4...chunk_values.
Cut cut(Interpolation rule, std::uint32_t knots, std::size_t values = message_values);
/// The division used by the sender of the header, per_chunk >= 1.
Cut cut(const Header& header);

/// True if this is a valid name of an executor.
bool is_executor_name(std::string_view name);
inline constexpr const char* executor_name_rule =
    "must have 1 to 23 characters, each a letter A-Z or a-z, a digit, _ or -";

}  // namespace jounce::wire
