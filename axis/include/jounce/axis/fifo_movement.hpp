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

/// A motion that arrives row by row while the axis plays it: a rolling stream, for paths longer
/// than memory or computed on the fly, or a Googol controller's two FIFOs.
///
///     FifoPath path(1, {.each = 1000, .limits = row_limits(config)});  // communication thread
///     for (const SegmentRow& row : ...) path.fifos().push(0, row);     // the prefill: while space
///     ... arm and start it ...                                         // the axis steps it
///     while (path.fifos().push(0, next) == RowRule::none) ...          // as space comes back
///
/// **Threads.** One thread fills fifos(), another steps the axis (jounce/pvt/segment_fifos.hpp). If
/// the axis hands the movement back in mid-play, fifos().leave() makes it reusable.
///
/// **Stream** (the default): only its `last` row ends it. Before the available part is shorter than
/// a stop, the axis stops on it with the fault `underrun` (Movement::growing). After a reset and
/// more rows the stream resumes at its present point. If the axis does not stop it and it runs dry,
/// it is `broken` by `underrun` in that tick and repeats its last setpoint. **Tables** (`stream =
/// false`; Googol: static): each FIFO holds one table, and `first` plays `loops` passes; a switch
/// to the other FIFO takes place at the end of a pass. A table that ends at a nonzero velocity is
/// broken too.
///
/// **Position.** Rows are relative to `origin`, if given; with `from` they are absolute positions.
/// begin() rejects an axis that does not stand there. Without either, rows are relative to the
/// position of the axis at the start. `range` bounds the whole motion, relative to its start;
/// admit() compares it with the axis's limits. push() rejects rows of a stream that leave the
/// range. The passes of a table may add up, so each pass is checked before it begins: a pass that
/// would leave the range does not begin, and the pass before it is not `bounded()`, so that the
/// axis supervises it. Times in s, positions in u.
struct FifoSpec {
  std::size_t each = 32;  ///< rows a FIFO holds, > 0: Googol 32 or 1024; the sender's credit is two
  bool stream = true;
  std::int64_t loops = 1;  ///< loops of tables; below 1: endless
  std::optional<RowStart> from =
      {};                 ///< from of a stream: x and position at the start of its first row
  RowLimits limits = {};  ///< push() rejects a row beyond them
  std::optional<double> origin = {};                             ///< u: required start position
  SegmentFifos::Reach range{-RowLimits::none, RowLimits::none};  ///< u, from the start: <= 0, >= 0
  std::optional<std::size_t> total{};  ///< total rows of both FIFOs; omitted: twice `each`
};

/// Limits of an axis for rows over time: its velocity, acceleration and jerk; for a step of the
/// velocity, the change that its acceleration makes in a tick; its range if rows are positions
/// (FifoSpec::from).
RowLimits row_limits(const AxisConfig& config, bool absolute = false);

/// A path over time.
class FifoPath final : public Movement {
 public:
  /// Allocates. Throws InputError "each" for 0 or more than 1e6, "from" for a number that is not
  /// finite.
  FifoPath(std::uint64_t id, const FifoSpec& spec);

  [[nodiscard]] SegmentFifos& fifos() { return fifos_; }
  /// Selects the FIFO that begin() starts; for tables.
  void choose(int fifo) { first_.store(fifo); }
  void see(std::uint64_t number) noexcept override { fifos_.see(number); }

  /// no_movement: no row was pushed, or the FIFOs are being cleared; start_position;
  /// start_velocity.
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
  bool fresh_ = false;  // begun, and nothing played yet
  Progress progress_ = Progress::running;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

/// Follow tables over the axis's live master: rows over its travel, in its unit. Googol's follow
/// mode (manual 7.6) starts at once or when the master passes a position, in one direction or both.
///
///     FifoFollow follow(2, {.each = 16, .stream = false, .loops = 0}, {.event = pass});
///     for (const PtPoint& p : shear) push(follow.fifos(), 0, p);
///     ... gear_in or arm and start; later, while it plays:
///     for (const PtPoint& p : bridge) push(follow.fifos(), 1, p);
///     follow.fifos().queue_switch();              // at the end of the pass; then FIFO 0 is empty
///
/// It is `waiting` until the event, and done at the end of its table. A table that ends at a
/// nonzero ratio keeps that ratio in this tick; the axis then brakes within its limits, as after a
/// cam. It is `broken` if the master is lost.
class FifoFollow final : public Movement {
 public:
  /// Throws like FifoPath, and for an event or a direction out of range
  /// (jounce/gear/follow_start.hpp).
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
  SegmentFifos::Reach range_;  // range from the origin: tolerance of the start
  FollowRun run_;
  std::atomic<int> first_{0};
  bool fresh_ = false;  // begun, and nothing played yet
  Sample before_;
  Progress progress_ = Progress::waiting;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

}  // namespace jounce
