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
#include "jounce/executor/histogram.hpp"

namespace jounce {

/// The clock of the cycle; a test provides its own. Nanoseconds since any fixed instant.
class Pacer {
 public:
  virtual ~Pacer() = default;
  [[nodiscard]] virtual std::int64_t now() = 0;
  virtual void sleep_until(std::int64_t instant) = 0;

 protected:
  Pacer() = default;
  Pacer(const Pacer&) = default;
  Pacer& operator=(const Pacer&) = default;
};

/// CLOCK_MONOTONIC with absolute deadlines. A relative sleep would accumulate delay, and the other
/// system clocks jump when the time is set.
class MonotonicPacer final : public Pacer {
 public:
  [[nodiscard]] std::int64_t now() override;
  void sleep_until(std::int64_t instant) override;
};

/// The answer of the axis to a command, and returned movements, in one tick.
struct Answer {
  std::uint64_t id = 0;  ///< id of the command; 0: none
  std::optional<Refusal> refused{};
  decltype(Tick::handed_back) handed_back{};
};

/// The exchange between one axis in the cyclic thread and the communication thread. Ticks may be
/// lost if no thread reads them for two thousand cycles. Answers may not: at most `most_commands`
/// commands with a number may be unanswered.
struct AxisExchange {
  static constexpr std::size_t most_commands = 8;
  static constexpr std::size_t most_ticks = 2048;
  Ring<Command, most_commands> commands;
  Ring<Answer, 4 * most_commands> answers;
  Ring<Tick, most_ticks> ticks;
  std::atomic<std::int64_t> lost{0};   ///< ticks dropped because the ring was full
  std::atomic<std::uint64_t> rows{0};  ///< number of the last row for its queues
};

/// The state of the cycle, and the heartbeat of the communication thread.
struct CycleStatus {
  static constexpr std::int64_t not_started = std::numeric_limits<std::int64_t>::min();
  std::atomic<std::int64_t> start{not_started};  ///< ns, by the pacer's clock: time of tick 0
  std::atomic<std::uint64_t> alive{0};  ///< heartbeat: incremented by the communication thread
  std::atomic<std::int64_t> late{0};    ///< cycles that began a period or more after their instant
  Histogram lateness;                   ///< lateness of wake-up: relative to the time of the tick
  Histogram computing;                  ///< time from wake-up to the output of the setpoints
};

/// The exchange of a whole machine between the two threads: that of each axis, the last value of
/// each master, and the state of the cycle.
struct MachineExchange {
  explicit MachineExchange(std::size_t of_axes, std::size_t of_masters = 0)
      : axes(of_axes), masters(of_masters) {
    for (auto& one : axes) one = std::make_unique<AxisExchange>();
    for (auto& one : masters) {
      one = std::make_unique<Seqlock<MasterSight>>();
      one->write({});
    }
  }
  std::vector<std::unique_ptr<AxisExchange>> axes;
  std::vector<std::unique_ptr<Seqlock<MasterSight>>> masters;
  CycleStatus cycle;
};

/// Timing statistics of the cycle.
struct CycleCounts {
  std::int64_t ticks = 0;        ///< steps made
  std::int64_t late = 0;         ///< steps that began a period or more after their instant
  std::int64_t skipped = 0;      ///< tick numbers skipped because of that
  std::int64_t latest_ns = 0;    ///< the longest delay of a step
  std::int64_t computed_ns = 0;  ///< the longest computation of a step
  std::int64_t lost = 0;         ///< ticks dropped because their ring was full
};

class RecordBuffer;

/// Parts of a cycle besides the machine; all of them must outlive the cycle.
struct CycleOptions {
  std::vector<AxisDrive*> drives = {};  ///< one per axis, or null; empty: none
  std::vector<Master*> masters = {};    ///< all masters of the machine
  std::int64_t patience = 0;            ///< cycles, see Watchdog; 0: no watchdog
  RecordBuffer* record = nullptr;       ///< receives the record; null: no record
};

/// The real-time loop: waits for the next tick, reads commands and feedback, evaluates the masters
/// at that time (in s since tick 0), steps the machine once, sends the setpoints to the drives, and
/// hands over the outputs.
///
///     MachineExchange exchange(machine.size());
///     Cycle cycle(machine, pacer, exchange);
///     while (!quit) cycle.once();
///
/// Tick k belongs to the instant start + k * period. A cycle that wakes up late continues with the
/// tick of the present time, and the axes skip the ticks before: never a burst of steps. Each axis
/// executes one command a tick.
///
/// **Watchdog.** Without a heartbeat of the communication thread for `patience` cycles, each axis
/// receives Inputs::watchdog, because no client could stop it any more. The watchdog counts cycles,
/// not time: a pause of the whole computer does not trigger it.
///
/// once() does not allocate, lock, log or wait for another thread.
class Cycle {
 public:
  /// All must outlive it.
  Cycle(Machine& machine, Pacer& pacer, MachineExchange& exchange, CycleOptions options = {});

  void once();
  [[nodiscard]] const CycleCounts& counts() const { return counts_; }

 private:
  void read();
  void look(std::int64_t tick);
  void write();
  [[nodiscard]] bool silent();
  void account(std::int64_t delay, std::int64_t missed, std::int64_t woken);

  Machine& machine_;
  Pacer& pacer_;
  MachineExchange& exchange_;
  CycleOptions options_;
  std::vector<AxisImage> images_;
  std::vector<MasterSight> sights_;
  std::vector<Jet> masters_;      // values of the masters
  std::uint64_t alive_ = 0;       // the last heartbeat seen
  std::int64_t since_alive_ = 0;  // cycles
  std::int64_t start_;
  std::int64_t next_ = 0;  // tick
  CycleCounts counts_;
};

}  // namespace jounce
