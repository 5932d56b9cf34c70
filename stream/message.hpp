#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "jounce/cam/coupling.hpp"
#include "jounce/io/hash.hpp"
#include "jounce/pvt/table.hpp"

/// The messages of stream protocol version 1, as values. docs/stream-protocol.md tells who sends
/// which when; stream/lcm/*.lcm is their layout on the wire; wire.hpp turns one into the other.
namespace jounce::wire {

inline constexpr std::int32_t protocol_version = 1;
inline constexpr std::size_t chunk_values = 1600;  ///< doubles a chunk can carry: 12.8 KB
inline constexpr std::size_t executor_bytes = 24;  ///< of an executor's name, final zero included
inline constexpr std::size_t unit_bytes = 16;      ///< of a unit, final zero included
inline constexpr std::size_t reason_bytes = 160;   ///< of a reason in words, final zero included
inline constexpr std::uint32_t most_tables = 64;   ///< of one session

/// What drives the slave.
enum class ArmMode : std::int8_t {
  play = 0,          ///< the slave table is over time and plays by itself
  follow_input = 1,  ///< the slave table is over master and follows the executor's master input
  follow_table = 2,  ///< the slave table is over master and follows a master table over time
};

enum class StopMode : std::int8_t {
  stop = 0,   ///< a jerk-limited stop, as the axis is configured
  abort = 1,  ///< the fastest stop the axis has
};

/// Why the executor refuses; 0 is no refusal. The words are in name(Refusal).
enum class Refusal : std::int8_t {
  none = 0,
  busy = 1,         ///< the axis belongs to another live session
  unknown_session,  ///< no header opened this session: the executor has restarted
  session_ended,    ///< this session was released, timed out, or was ended by an operator's stop
  bad_header,       ///< the header contradicts itself, or an earlier one of the same index
  too_large,        ///< more knots than the executor allows
  out_of_memory,    ///< the executor's memory for tables is full
  bad_chunk,        ///< a chunk contradicts its header
  hash_mismatch,    ///< every chunk arrived, but this is not the table that was announced
  bad_table,        ///< it is, but no table: see the reason
  table_missing,    ///< the table to arm has not completely arrived
  wrong_axis,       ///< a table over time where one over master is needed, or the reverse
  wrong_unit,       ///< a table over time not in s, or a master that counts in another unit
  not_armed,        ///< start without arm
  axis,             ///< the axis said no: see the reason
};

/// How far a command has come.
enum class Outcome : std::int8_t { pending = 0, accepted = 1, refused = 2 };

/// What the axis does: the states of PLCopen that an axis which plays tables needs.
enum class AxisState : std::int8_t {
  disabled = 0,
  standstill = 1,
  discrete_motion = 2,      ///< plays a table over time
  synchronized_motion = 3,  ///< follows a master
  stopping = 4,             ///< on its way to rest
  error_stop = 5,           ///< latched; see last_error
};

/// What it will do next.
enum class Next : std::int8_t {
  nothing = 0,
  armed = 1,    ///< a table waits for its start
  waiting = 2,  ///< the start waits for its tick
};

// ---- from the streamer -------------------------------------------------------------------------

/// Announces a table; the first one of a session opens it.
struct Header {
  std::uint32_t table = 0;  ///< index within the session, 0...63
  Sha256 hash{};            ///< content_hash(table, units)
  Axis axis = Axis::time;
  Rule rule = Rule::linear;
  Outside outside = Outside::refuse;
  Units units;
  std::uint32_t knots = 0;    ///< >= 2
  std::uint32_t columns = 0;  ///< 2...4, as the rule needs
  std::uint32_t chunks = 0;   ///< ceil(knots / (chunk_values / columns))
};

/// Some knots, column after column: x of all, then p of all, ...
struct Chunk {
  std::uint32_t table = 0;
  std::uint32_t seq = 0;         ///< 0...chunks - 1
  std::uint32_t first_knot = 0;  ///< seq * (chunk_values / columns)
  std::uint32_t knots = 0;       ///< full but for the last chunk
  std::uint32_t columns = 0;
  std::vector<double> values{};  ///< knots * columns <= chunk_values
};

/// Commands are numbered within a session, from 1, rising. A repeated number is answered with the
/// recorded outcome, a lower one than the last is ignored: a late start cannot undo a stop.
struct Arm {
  std::int32_t command = 0;
  ArmMode mode = ArmMode::play;
  Sha256 slave{};           ///< hash of the slave table
  Sha256 master{};          ///< hash of the master table; zero unless mode is follow_table
  CouplingSpec coupling{};  ///< of a slave table over master; without master_jump
};

struct Start {
  std::int32_t command = 0;
  std::int64_t tick = -1;  ///< the executor's tick at which it begins; -1: the next one
};

/// In session 0: an operator's stop, which ends whatever session lives.
struct Stop {
  std::int32_t command = 0;
  StopMode mode = StopMode::stop;
};

/// Keeps a session alive, or ends it. A motion goes on without its session.
struct Heartbeat {
  std::int32_t command = 0;
  bool release = false;
};

// ---- from the executor -------------------------------------------------------------------------

/// How far a table has come.
struct Ack {
  std::int64_t boot = 0;     ///< drawn when the executor starts: another one means it has forgotten
  std::uint32_t table = 0;   ///< index within the session
  std::uint32_t next = 0;    ///< every chunk below has arrived
  std::uint64_t mask = 0;    ///< bit i: chunk next + 1 + i has arrived
  std::uint32_t credit = 0;  ///< chunks from `next` on that may be under way
  bool complete = false;     ///< the table is whole, its hash matches, and it is stored
  Refusal refusal = Refusal::none;
  std::string reason{};  ///< in words; may be empty
};

/// How far a command has come.
struct Reply {
  std::int64_t boot = 0;
  std::int32_t command = 0;
  Outcome outcome = Outcome::pending;
  Refusal refusal = Refusal::none;
  std::int32_t cause = 0;  ///< the axis's own number where it refuses
  std::string reason{};
};

/// What the axis does now; published every few milliseconds, only the newest counts.
struct Status {
  AxisState state = AxisState::disabled;
  Next next = Next::nothing;
  std::int64_t tick = 0;                ///< number of this cycle
  std::int64_t cycle_ns = 1;            ///< length of a cycle, ns, > 0
  double master_position = 0;           ///< the unit of the slave table's x; NaN: no master
  double slave_position = 0;            ///< the unit of the slave table's position
  double slave_velocity = 0;            ///< that unit per second
  std::array<std::uint8_t, 8> table{};  ///< first bytes of the slave table's hash; zeros: none
  std::int32_t last_error = 0;          ///< the axis's own number; 0: none
  std::int64_t late_ticks = 0;          ///< cycles that began too late, since the executor started
  std::int64_t finished = 0;            ///< motions that reached their end, since then
  std::int64_t stopped = 0;             ///< motions that a stop brought to rest, since then
};

using Body = std::variant<Header, Chunk, Arm, Start, Stop, Heartbeat, Ack, Reply, Status>;

struct Message {
  std::string executor;      ///< 1 to 23 of A-Z a-z 0-9 _ -
  std::int64_t session = 0;  ///< > 0; 0: none (Status of an idle axis, an operator's Stop)
  Body body;
};

const char* name(ArmMode mode);
const char* name(Refusal refusal);
const char* name(AxisState state);
const char* name(Next next);

/// How a table is cut into chunks.
struct Cut {
  std::uint32_t columns = 0;    ///< 2, 3 or 4, as the rule needs
  std::uint32_t per_chunk = 0;  ///< knots of a full chunk
  std::uint32_t chunks = 0;

  /// Knots of chunk `seq`.
  [[nodiscard]] std::uint32_t knots_of(std::uint32_t seq, std::uint32_t knots) const;
};
Cut cut(Rule rule, std::uint32_t knots);

/// Whether this is a name that an executor may have.
bool is_executor_name(std::string_view name);

}  // namespace jounce::wire
