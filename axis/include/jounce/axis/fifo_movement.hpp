// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/gear/follow_run.hpp"

namespace jounce {

/// A motion that arrives row by row while the axis plays it: a rolling stream, for paths
/// longer than memory or computed on the fly, or a Googol controller's two FIFOs.
///
///     FifoPath path(1, {.each = 1000, .limits = row_limits(config)});  // communication thread
///     for (const SegmentRow& row : ...) path.fifos().push(0, row);     // the prefill: while space
///     ... arm and start it ...                                         // the axis steps it
///     while (path.fifos().push(0, next) == RowRule::none) ...          // as space comes back
///
/// **Threads.** fifos() is filled by one thread, the axis plays in another (jounce/pvt/segment_fifos.hpp).
/// A movement that was handed back in mid-play is free again after fifos().leave().
///
/// **Stream** (the default): open, so that it ends with its `last` row alone. Before less of it is
/// known than a stop takes, the axis stops on it with the fault `underrun` (Movement::growing); after
/// reset and more rows it resumes where it stands. A stream that is never stopped and runs dry is
/// `broken` by `underrun` in the very tick: its setpoint stays the one before.
/// **Tables** (`stream = false`; Googol: static): each FIFO is one, `loops` passes of `first`; another
/// is switched to at the end of a pass. A table that ends at a rate is broken too.
///
/// **Where it lies.** With `origin` rows count from there, with `from` they are positions; begin()
/// refuses an axis that does not stand there. Without either, rows count from where the axis stands.
/// `range` is what the whole motion keeps to, from where it begins; admit() compares it with the axis's
/// limits. Rows of a stream that leave it are refused when they are pushed. Of tables, whose passes may
/// add up, each pass is compared before it begins: one that would leave the range does not begin, and the
/// pass before it is not `bounded()`, so that the axis supervises it. Times in s, positions in u.
struct FifoSpec {
  std::size_t each = 32;  ///< rows a FIFO holds, > 0: Googol 32 or 1024; the sender's credit is two
  bool stream = true;
  std::int64_t loops = 1;  ///< loops of tables; below 1: endless
  std::optional<RowStart> from =
      {};                 ///< from of a stream: x and position of its first row's beginning
  RowLimits limits = {};  ///< a row beyond them is refused when it is pushed
  std::optional<double> origin = {};                             ///< u: where the axis must stand
  SegmentFifos::Reach range{-RowLimits::none, RowLimits::none};  ///< u, from there: <= 0, >= 0
  std::optional<std::size_t> total{};  ///< rows of both together; left out: twice `each`
};

/// Limits of an axis for rows over time: its velocity, acceleration and jerk; of a step of the
/// velocity what its acceleration makes in a tick; its range where rows are positions (FifoSpec::from).
RowLimits row_limits(const AxisConfig& config, bool absolute = false);

/// A path over time.
class FifoPath final : public Movement {
 public:
  /// Allocates. Throws InputError "each" for 0 or more than 1e6, "from" for numbers not finite.
  FifoPath(std::uint64_t id, const FifoSpec& spec);

  [[nodiscard]] SegmentFifos& fifos() { return fifos_; }
  /// The FIFO that begin() starts; of tables.
  void choose(int fifo) { first_.store(fifo); }
  void see(std::uint64_t number) noexcept override { fifos_.see(number); }

  /// no_movement: nothing was pushed, or it is being cleared; start_position; start_velocity.
  [[nodiscard]] std::optional<Refusal> admit(const AxisConfig& config,
                                             const MotionState& axis) const noexcept override;
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override { return cause_; }
  [[nodiscard]] bool absolute() const noexcept override { return origin_.has_value(); }
  [[nodiscard]] double known() const noexcept override;
  [[nodiscard]] bool growing() const noexcept override { return fifos_.growing(); }
  [[nodiscard]] Peaks peaks() const noexcept override;
  [[nodiscard]] int direction() const noexcept override { return fifos_.direction(first_.load()); }
  [[nodiscard]] bool bounded() const noexcept override { return bounded_; }

 private:
  [[nodiscard]] std::optional<Refusal> leaves(const AxisConfig& config, double from) const;
  [[nodiscard]] bool within(const SegmentFifos::Reach& pass) const;
  void supervise();

  SegmentFifos fifos_;
  std::optional<double> origin_;
  SegmentFifos::Reach range_;  // from the origin
  double begun_at_ = 0;        // u
  bool bounded_ = true;
  std::atomic<int> first_{0};
  bool fresh_ = false;  // begun, and nothing was played
  Progress progress_ = Progress::running;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

/// Follow tables over the axis's live master: rows over its travel, in its unit. Googol's follow mode
/// (manual 7.6): at once or when the master passes a position, in one direction or both.
///
///     FifoFollow follow(2, {.each = 16, .stream = false, .loops = 0}, {.event = pass});
///     for (const PtPoint& p : shear) push(follow.fifos(), 0, p);
///     ... gear_in or arm and start; later, while it plays:
///     for (const PtPoint& p : bridge) push(follow.fifos(), 1, p);
///     follow.fifos().queue_switch();              // at the end of the pass; then FIFO 0 is empty
///
/// While the event has not come it is `waiting`. A table that has ended is done. One that ends at a ratio
/// moves on at it in that tick, and the axis brakes from there within its limits, as after a cam. A
/// master that is lost breaks it.
class FifoFollow final : public Movement {
 public:
  /// Like FifoPath; also for an event or a direction out of range (jounce/gear/follow_start.hpp).
  FifoFollow(std::uint64_t id, const FifoSpec& spec, const FollowRun& run = {});

  [[nodiscard]] SegmentFifos& fifos() { return fifos_; }
  void choose(int fifo) { first_.store(fifo); }
  void see(std::uint64_t number) noexcept override { fifos_.see(number); }

  /// start_position: the axis does not stand at the origin.
  [[nodiscard]] std::optional<Refusal> admit(const AxisConfig& config,
                                             const MotionState& axis) const noexcept override;
  /// no_master_input, no_movement, start_position.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override { return cause_; }
  [[nodiscard]] bool absolute() const noexcept override { return origin_.has_value(); }

 private:
  [[nodiscard]] Jet beyond(double master) const noexcept;

  SegmentFifos fifos_;
  std::optional<double> origin_;
  SegmentFifos::Reach range_;  // from the origin: how near is there
  FollowRun run_;
  std::atomic<int> first_{0};
  bool fresh_ = false;  // begun, and nothing was played
  Sample before_;
  Progress progress_ = Progress::waiting;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

}  // namespace jounce
