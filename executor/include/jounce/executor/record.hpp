// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/job.hpp"
#include "jounce/axis/live_cam.hpp"
#include "jounce/axis/master.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/executor/queues.hpp"
#include "jounce/executor/recorded_output.hpp"

namespace jounce {

/// Parts of the record of a run: one event each, in chronological order. A record is an LCM log:
/// `lcm-logplayer` plays it, `lcm-spy` shows it with the types of executor/lcm, and
/// docs/executor/replay.md describes it for users. Ticks are its only time: the events' time stamps
/// are tick * period in us, independent of the clock.

/// Configuration of an axis; precedes all other events of that axis.
struct RecordedAxis {
  std::size_t axis = 0;  ///< counted from 0
  std::string name = {};
  Units units = {};  ///< x: the master's
  AxisConfig config = {};
  bool whole = true;          ///< false: a black box, which begins in the middle of a run
  bool switches = false;      ///< it has outputs that are not in the record: no replay
  AxisSwitches outputs = {};  ///< follow as RecordedOutput
  AxisCompare compare = {};   ///< likewise
};

/// A table, or a part of a large one: 200 knots per event.
struct RecordedTable {
  Sha256 hash{};
  Units units = {};
  Domain over = Domain::time;
  Interpolation rule = Interpolation::linear;
  Extrapolation outside = Extrapolation::hold;
  std::size_t knots = 0;
  std::size_t first = 0;
  Columns columns = {};  ///< columns of this part
};

/// Parts of a Job or a LiveCam; its tables by their hashes.
struct RecordedJob {
  std::size_t axis = 0;
  std::uint64_t id = 0;
  Sha256 time{};  ///< live: hash of the cam
  std::optional<Sha256> cam = {};
  bool live = false;  ///< the cam follows the axis's live master
  double tick = 1e-3;
  CouplingSpec coupling = {};
  double position = 0;
  CamEnd end = CamEnd::brake;  ///< for a live cam
};

/// Parts of the movement of a gear: its command (gear_of()) and the position of the slave.
struct RecordedGear {
  std::size_t axis = 0;
  std::uint64_t id = 0;
  ClientCommand gear = command::GearIn{};
  double position = 0;
};

/// A queue that was opened: those fields of the wire's queue that define its movement.
struct RecordedQueue {
  std::size_t axis = 0;
  std::uint64_t id = 0;
  wire::Queue queue = {};
};

/// Rows passed to a queue; many rows make several of these.
struct RecordedRows {
  std::size_t axis = 0;
  HandedOver what = {};
};

/// One axis in one tick: its command, inputs and outputs. The command's movement is identified by
/// its number; `tick` does not contain the edges of its switches or the returned movements.
struct RecordedCycle {
  std::size_t axis = 0;
  Command command = {};
  std::uint64_t movement = 0;
  Inputs inputs = {};
  Tick tick = {};
};

/// A master of the machine at its start; comes after the axes.
struct RecordedMaster {
  std::size_t master = 0;  ///< counted from 0
  std::string name = {};
  std::string unit = {};
  std::uint64_t followers = 0;  ///< bit i: axis i follows it
  enum class Made : std::uint8_t {
    elsewhere,  ///< not in the record: its value is an input
    samples,    ///< an ExternalMaster
    readings,   ///< an EncoderMaster
  };
  Made made = Made::elsewhere;
  TrackerSpec tracker = {};  ///< unused for `elsewhere`
};

/// Input of the next value of a master: one of its samples, or its reading.
struct RecordedSample {
  std::size_t master = 0;
  MasterSample sample = {};
};

/// State of a master in a cycle, before the axes of the same tick.
struct RecordedSight {
  std::size_t master = 0;
  MasterSight sight = {};
};

/// Cycles that are missing at this point.
struct RecordedLoss {
  std::int64_t cycles = 0;
};

using RecordEvent = std::variant<RecordedAxis, RecordedTable, RecordedJob, RecordedCycle,
                                 RecordedLoss, RecordedQueue, RecordedRows, RecordedGear,
                                 RecordedMaster, RecordedSight, RecordedOutput, RecordedSample>;

/// The channel of an event, "JOUNCE.cycle", and its bytes by LCM's rules.
std::string_view channel_of(const RecordEvent& event);
std::string encoded(const RecordEvent& event);
/// Returns nullopt for a channel of another program. Throws InputError for bytes that are not an
/// event.
std::optional<RecordEvent> decoded(std::string_view channel, std::string_view bytes);

/// A field in which two ticks differ, to the last bit.
struct TickDifference {
  std::string field;  ///< "position", "state", ..., like in cycle_t
  double recorded = 0;
  double replayed = 0;
};
/// Returns the first one, in the order of cycle_t. `switches`: also compares outputs and the
/// instants of their edges.
std::optional<TickDifference> first_difference(const Tick& recorded, const Tick& replayed,
                                               bool switches = true);

}  // namespace jounce
