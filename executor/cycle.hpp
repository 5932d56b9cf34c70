#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "jounce/executor/axis.hpp"
#include "jounce/executor/ring.hpp"

namespace jounce {

/// What the cycle is paced by; a test brings its own. Nanoseconds since any fixed instant.
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

/// CLOCK_MONOTONIC with absolute deadlines: a relative sleep would fall behind without end.
class MonotonicPacer final : public Pacer {
 public:
  [[nodiscard]] std::int64_t now() override;
  void sleep_until(std::int64_t instant) override;
};

/// What the axis answered to a command, or handed back, in one tick.
struct Answer {
  std::uint64_t id = 0;  ///< of the command; 0: there was none
  std::optional<Refusal> refused{};
  std::array<const Movement*, 3> handed_back{};
};

/// All that passes between the cyclic thread and the one that communicates. Ticks may be lost where
/// nobody takes them. Answers may not: at most `most_commands` with a number may be unanswered.
struct Mail {
  static constexpr std::size_t most_commands = 8;
  Ring<Command, most_commands> commands;
  Ring<Answer, 4 * most_commands> answers;
  Ring<Tick, 8192> ticks;
};

/// How well the cycle kept time.
struct CycleCounts {
  std::int64_t ticks = 0;      ///< steps made
  std::int64_t late = 0;       ///< that began a period or more after their instant
  std::int64_t skipped = 0;    ///< tick numbers left out because of that
  std::int64_t latest_ns = 0;  ///< the longest delay of a step
  std::int64_t lost = 0;       ///< ticks that found the ring full
};

/// The real-time loop: waits for the next instant, steps the axis once, and posts what it said.
///
///     Cycle cycle(axis, pacer, mail);
///     while (!quit) cycle.once();
///
/// Tick k belongs to the instant start + k * period. A cycle that wakes up late goes on with the
/// tick that the time has come for, and the axis leaves out those before: never a burst of steps.
/// once() neither allocates, locks, logs nor waits for another thread.
class Cycle {
 public:
  Cycle(MotionAxis& axis, Pacer& pacer, Mail& mail);

  void once();
  [[nodiscard]] const CycleCounts& counts() const { return counts_; }

 private:
  void post(const Command& command, const Tick& tick);

  MotionAxis& axis_;
  Pacer& pacer_;
  Mail& mail_;
  std::int64_t start_;
  std::int64_t next_ = 0;  // tick
  CycleCounts counts_;
};

/// Asks for SCHED_FIFO at this priority for the calling thread, locks all memory and touches the
/// stack, each as far as it is permitted. The answer says in words what was granted.
std::string make_realtime(int priority);

}  // namespace jounce
