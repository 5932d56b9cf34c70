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

/// Options of a motion that arrives row by row while the axis plays it: a rolling stream, or the
/// two FIFOs of a Googol controller. Use a rolling stream for a path that is longer than the
/// memory, or that is computed while it is played.
///
///     FifoPath path(1, {.each = 1000, .limits = row_limits(config)});  // communication thread
///     for (const SegmentRow& row : rows) path.fifos().push(0, row);    // the prefill: while space
///     // arm and start it: the axis steps it
///     while (path.fifos().push(0, next) == RowRule::none) ...          // as space comes back
///
/// **Units.** x and times in s, positions in u, the unit of the axis.
///
/// **Threads.** One thread fills fifos(), another one steps the axis
/// (jounce/pvt/segment_fifos.hpp). If the axis returns the movement before its end, call
/// fifos().leave() before you reuse the movement.
///
/// **Stream** (the default). The stream ends with a row that is marked `last`. If no more rows
/// arrive, the axis stops on the path, with the fault `underrun`, before the remaining rows are
/// shorter than its stopping distance (Movement::growing). After a reset and more rows, the stream
/// resumes at its present point. If the rows run out although the axis did not stop, the movement
/// becomes `broken` by `underrun` in that tick and repeats its last setpoint.
///
/// **Tables** (`stream = false`; Googol calls them static). Each FIFO holds one table. The axis
/// begins with the FIFO that choose() selects, and plays it for `loops` passes. A switch to the
/// other FIFO takes place at the end of a pass. A table that ends at a nonzero velocity is `broken`
/// at its end.
///
/// **Position.** If `origin` is given, rows are relative to this position. If `from` is given, rows
/// are absolute positions. In these two cases, begin() rejects an axis that does not stand at the
/// start position. If neither is given, rows are relative to the position of the axis at the start.
///
/// **Range.** `range` bounds the whole motion, relative to its start. admit() compares the range
/// with the limits of the axis, and push() rejects rows of a stream that leave the range. The
/// travel of the passes of a table may add up, so each pass is checked before it begins, and a pass
/// that would leave the range does not begin. During the pass before it, `bounded()` returns false,
/// and the axis itself supervises the position.
struct FifoSpec {
  /// Rows in one FIFO, 1 to 1e6; Googol: 32 or 1024. A sender may send up to 2 * each rows ahead.
  std::size_t each = 32;
  bool stream = true;      ///< true: a rolling stream; false: tables
  std::int64_t loops = 1;  ///< passes of the first table; below 1: endless
  /// Start of the first row: x (s) and position (u); for a stream.
  std::optional<RowStart> from = {};
  RowLimits limits = {};              ///< limits of the rows: push() rejects a row that exceeds
                                      ///< them
  std::optional<double> origin = {};  ///< required start position, u; nullopt: any
  /// Lowest (<= 0) and highest (>= 0) position relative to the start, u.
  SegmentFifos::Reach range{-RowLimits::none, RowLimits::none};
  std::optional<std::size_t> total{};  ///< rows of both FIFOs together; nullopt: 2 * each
};

/// Returns the limits of an axis for rows over time: its velocity, acceleration and jerk. The
/// permitted step of the velocity is the change of velocity that the acceleration limit allows in
/// one tick. `absolute` is true if the rows are absolute positions (FifoSpec::from): then the
/// position range of the axis applies, too.
RowLimits row_limits(const AxisConfig& config, bool absolute = false);

/// A path over time that arrives row by row.
class FifoPath final : public Movement {
 public:
  /// Allocates the FIFOs. `id` is the id of the motion in Tick::job. Throws InputError "each" for 0
  /// or more than 1e6, and "from" for a number that is not finite.
  FifoPath(std::uint64_t id, const FifoSpec& spec);

  /// The FIFOs, for the thread that fills them.
  [[nodiscard]] SegmentFifos& fifos() { return fifos_; }
  /// Selects the FIFO that begin() starts, 0 or 1; for tables.
  void choose(int fifo) { first_.store(fifo); }
  void see(std::uint64_t number) noexcept override { fifos_.see(number); }

  /// Returns nullopt, or a refusal: no_movement (no row was pushed, or the FIFOs are being
  /// cleared), start_position, start_velocity, position_limit, velocity_limit, or
  /// acceleration_limit.
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
  SegmentFifos::Reach range_;  // relative to the origin
  double begun_at_ = 0;        // u
  bool bounded_ = true;
  std::atomic<int> first_{0};
  bool fresh_ = false;  // begun, and nothing played yet
  Progress progress_ = Progress::running;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

/// Follow tables over the live master of the axis: rows over the travel of the master, in its unit.
/// The motion starts at once, or when the master passes a position. The axis follows the master in
/// one direction or in both (Googol's follow mode, section 7.6 of the Googol manual).
///
///     FifoFollow follow(2, {.each = 16, .stream = false, .loops = 0}, {.event = pass});
///     for (const SegmentRow& row : shear) follow.fifos().push(0, row);
///     // arm and start it; later, while it plays:
///     for (const SegmentRow& row : bridge) follow.fifos().push(1, row);
///     follow.fifos().queue_switch();              // at the end of the pass; then FIFO 0 is empty
///
/// Progress: `waiting` until the event, then `running`, and `done` at the end of the table. If the
/// table ends at a nonzero ratio, the slave keeps this ratio for one tick; the axis then brakes
/// within its limits, as after a cam. Progress is `broken` if the master is lost.
class FifoFollow final : public Movement {
 public:
  /// Throws InputError like FifoPath, and for an event or a direction out of range
  /// (jounce/gear/follow_start.hpp).
  FifoFollow(std::uint64_t id, const FifoSpec& spec, const FollowRun& run = {});

  /// The FIFOs, for the thread that fills them.
  [[nodiscard]] SegmentFifos& fifos() { return fifos_; }
  /// Selects the FIFO that begin() starts, 0 or 1.
  void choose(int fifo) { first_.store(fifo); }
  void see(std::uint64_t number) noexcept override { fifos_.see(number); }

  /// Returns a refusal, start_position, if the axis does not stand at the origin.
  [[nodiscard]] std::optional<Refusal> admit(const AxisConfig& config,
                                             const MotionState& axis) const noexcept override;
  /// Returns no_master_input, no_movement, start_position, or none.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override { return cause_; }
  [[nodiscard]] bool absolute() const noexcept override { return origin_.has_value(); }
  [[nodiscard]] std::optional<MotionState> first_setpoint(
      const Moment& now) const noexcept override;
  /// The greatest slopes of the rows so far.
  [[nodiscard]] std::array<double, 3> slopes() const noexcept override;
  /// The beginning of each table, and the ends of its passes.
  [[nodiscard]] std::span<const ProfileEvent> events() const noexcept override {
    return events_.events();
  }

 private:
  [[nodiscard]] Jet beyond(double master) const noexcept;
  void note(ProfileEvent::Kind kind, std::int64_t number, double master, const Sample& now);
  void note_passes(int table, const Sample& now);

  SegmentFifos fifos_;
  std::optional<double> origin_;
  SegmentFifos::Reach range_;  // relative to the origin; gives the tolerance of the start
  FollowRun run_;
  std::atomic<int> first_{0};
  bool fresh_ = false;  // begun, and nothing played yet
  Sample before_;
  ProfileStep events_;
  Progress progress_ = Progress::waiting;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

}  // namespace jounce
