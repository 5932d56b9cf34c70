// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "jounce/axis/machine.hpp"
#include "jounce/axis/master.hpp"
#include "jounce/axis/ring.hpp"
#include "jounce/drive/drive.hpp"
#include "jounce/drive/seqlock.hpp"
#include "jounce/executor/cycle_counts.hpp"
#include "jounce/executor/histogram.hpp"

namespace jounce {

/// The clock of the cycle. A test can provide its own.
class Pacer {
 public:
  virtual ~Pacer() = default;
  /// Time since a fixed instant, ns.
  [[nodiscard]] virtual std::int64_t now() = 0;
  /// Waits until this time, ns.
  virtual void sleep_until(std::int64_t instant) = 0;

 protected:
  Pacer() = default;
  Pacer(const Pacer&) = default;
  Pacer& operator=(const Pacer&) = default;
};

/// The system clock CLOCK_MONOTONIC, with absolute deadlines. Relative waits would accumulate
/// delay, and other clocks of the system jump when the time is set.
class MonotonicPacer final : public Pacer {
 public:
  [[nodiscard]] std::int64_t now() override;
  void sleep_until(std::int64_t instant) override;
};

/// Answer of an axis in one tick: the result of a command, and the movements that the axis
/// returned.
struct Answer {
  std::uint64_t id = 0;              ///< id of the command (Command::id); 0: no command
  std::optional<Refusal> refused{};  ///< reason for rejecting the command; nullopt: accepted
  /// Movements that the axis no longer reads.
  decltype(Tick::handed_back) handed_back{};
};

/// The exchange between one axis in the cyclic thread and the communication thread. If the
/// communication thread does not read ticks for about two thousand cycles, ticks are lost. Answers
/// are not lost, because at most `most_commands` commands with an id may be unanswered.
struct AxisExchange {
  static constexpr std::size_t most_commands = 8;  ///< greatest number of commands in transit
  static constexpr std::size_t most_ticks = 2048;  ///< greatest number of ticks that wait
  Ring<Command, most_commands> commands;           ///< from the communication thread
  Ring<Answer, 4 * most_commands> answers;         ///< from the cyclic thread
  Ring<Tick, most_ticks> ticks;                    ///< from the cyclic thread
  std::atomic<std::int64_t> lost{0};   ///< ticks that were dropped because the ring was full
  std::atomic<std::uint64_t> rows{0};  ///< number of the last available row of the axis's queues
};

/// State of the cycle, and the heartbeat of the communication thread.
struct CycleStatus {
  /// Value of `start` before the first tick.
  static constexpr std::int64_t not_started = std::numeric_limits<std::int64_t>::min();
  std::atomic<std::int64_t> start{not_started};  ///< time of tick 0 by the clock of the Pacer, ns
  std::atomic<std::uint64_t> alive{0};  ///< heartbeat: the communication thread increments it
  std::atomic<std::int64_t> late{0};    ///< number of cycles that began a period or more too late
  Histogram lateness = {};              ///< time from the instant of each tick to the wake-up
  Histogram computing = {};             ///< time from each wake-up to the output of the setpoints
};

/// The exchange of a whole machine between its two threads.
struct MachineExchange {
  /// Arguments: the numbers of axes and of masters.
  explicit MachineExchange(std::size_t of_axes, std::size_t of_masters = 0)
      : axes(of_axes), masters(of_masters) {
    for (auto& one : axes) one = std::make_unique<AxisExchange>();
    for (auto& one : masters) {
      one = std::make_unique<Seqlock<MasterReading>>();
      one->write({});
    }
  }
  std::vector<std::unique_ptr<AxisExchange>> axes;               ///< exchange of each axis
  std::vector<std::unique_ptr<Seqlock<MasterReading>>> masters;  ///< last value of each master
  CycleStatus cycle;                                             ///< state of the cycle
};

class RecordBuffer;

/// Parts of a cycle in addition to the machine. All of them must outlive the cycle.
struct CycleOptions {
  /// One for each axis, null for an axis without a drive. An empty list: no axis has a drive.
  std::vector<AxisDrive*> drives = {};
  std::vector<Master*> masters = {};  ///< all masters of the machine, in its order
  std::int64_t patience = 0;          ///< limit of the watchdog in cycles (see Cycle); 0: no
                                      ///< watchdog
  RecordBuffer* record = nullptr;     ///< receives the record of the run; null: no record
};

/// The real-time loop of a machine. In each tick it waits for the instant of the tick, reads
/// commands and feedback, computes the masters (their time is in s from tick 0), and steps the
/// machine once. Then it sends the setpoints to the drives, and passes the outputs to the
/// communication thread.
///
///     MachineExchange exchange(machine.size());
///     Cycle cycle(machine, pacer, exchange);
///     while (!quit) cycle.once();
///
/// The instant of tick k is start + k * period. A cycle that wakes up too late continues with the
/// tick of the present time, and the axes skip the ticks before this tick. So late steps are never
/// made up in a burst. Each axis executes at most one command in a tick.
///
/// **Watchdog.** If the communication thread sends no heartbeat for `patience` cycles, each axis
/// receives Inputs::watchdog and stops, because no client could stop it any more. The watchdog
/// counts cycles, not time, so a pause of the whole computer does not trigger it.
///
/// once() does not allocate, lock, log or wait for another thread.
class Cycle {
 public:
  /// All arguments must outlive the cycle. Throws InputError unless they have as many axes and
  /// masters as the machine.
  Cycle(Machine& machine, Pacer& pacer, MachineExchange& exchange, CycleOptions options = {});

  /// Waits for the next tick and computes it. Call in a loop.
  void once();
  /// Timing statistics so far.
  [[nodiscard]] const CycleCounts& counts() const { return counts_; }

 private:
  void read(std::int64_t tick);
  void look(std::int64_t tick);
  void write();
  [[nodiscard]] bool silent();
  void account(std::int64_t delay, std::int64_t missed, std::int64_t woken);

  Machine& machine_;
  Pacer& pacer_;
  MachineExchange& exchange_;
  CycleOptions options_;
  std::vector<AxisImage> images_;
  std::vector<MasterReading> sights_;
  std::vector<Jet> masters_;      // values of the masters
  std::uint64_t alive_ = 0;       // the last heartbeat seen
  std::int64_t since_alive_ = 0;  // cycles since the last new heartbeat
  std::int64_t start_;
  std::int64_t next_ = 0;  // number of the next tick
  CycleCounts counts_;
};

}  // namespace jounce
