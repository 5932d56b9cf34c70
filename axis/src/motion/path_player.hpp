// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/detail/path_clock.hpp"
#include "jounce/axis/movement.hpp"

namespace jounce {

/// Input of PathPlayer for the rate of a path (path_clock.hpp): the rate is the speed of
/// path time, 1 at the original speed.
struct PathRequest {
  std::int64_t tick = 0;  ///< the present tick
  double rate = 1;        ///< requested rate; 0: rest on the path
  Peaks added = {};       ///< peaks of a superimposed move
  /// Movement whose start was accepted and that will take over; null: none.
  const Movement* next = nullptr;
};

/// Plays a path: a movement of one axis that has its own time, such as a table or a stream of rows
/// (Course::path). The player keeps the clock of the path, the present place on the path, and the
/// boundary. The boundary is the path time at which the path ends early, or at which another path
/// takes over.
///
///     PathPlayer player(config);
///     player.begin(path, tick, 1, 0);
///     player.follow({.tick = 1000, .rate = 0});                         // a hold
///     if (player.starves({.tick = tick})) ...                           // a stop is necessary now
///     const Setpoint next = player.play(player.time(tick), moment);     // once a tick
///     player.put_out(tick);                                             // that setpoint was output
///
/// - Path time never runs backwards, and the setpoint never leaves the path.
/// - The rate is at most 2, and at most the highest rate at which the path stays within the limits
///   of the axis. After the start of another path was accepted, this applies to the other path,
///   too.
/// - A growing path (one that still receives rows) can stop within its available part at every
///   tick. starves() reports the last tick in which it can.
///
/// The player does not own the path. It does not allocate, lock or throw. Path times are in s.
class PathPlayer {
 public:
  explicit PathPlayer(const AxisConfig& config) : config_(config), clock_(config.period) {}

  /// Plays the path from now on. The path began `ahead` s before the given tick. Its rate is the
  /// lower of `rate` and the highest permitted rate.
  void begin(Movement& path, std::int64_t tick, double rate, double ahead) noexcept;
  /// Continues with another path from its beginning, at the instant at which the present path
  /// reaches the path time `boundary`, s.
  void take_over(Movement& path, std::int64_t tick, double boundary) noexcept;
  /// Ends the path, if there is one.
  void end() noexcept;

  /// True if a path is played.
  [[nodiscard]] explicit operator bool() const noexcept { return path_ != nullptr; }
  /// The path; null: none.
  [[nodiscard]] Movement* path() const noexcept { return path_; }
  [[nodiscard]] Movement* operator->() const noexcept { return path_; }

  // ---- the rate

  /// Changes to the requested rate, or to the highest permitted rate if that is lower. Returns
  /// false and changes nothing if the change is not possible.
  bool follow(const PathRequest& request) noexcept;
  /// Stops within the available part of the path. Returns false if that is not possible.
  bool stop(const PathRequest& request) noexcept;
  /// Call once a tick. Has no effect if the requested or the permitted rate is at most 1. On a
  /// growing path, raises the rate toward the requested one as far as the available part permits,
  /// with a margin, and returns to rate 1 when this part becomes too short. On any other path, acts
  /// like follow().
  void govern(const PathRequest& request) noexcept;
  /// True if the available part is shorter than a stop that begins in the next tick.
  [[nodiscard]] bool starves(const PathRequest& request) const noexcept;
  /// Returns the highest permitted rate that is not greater than `rate`. For `next`, see
  /// PathRequest.
  [[nodiscard]] double granted(double rate, const Movement* next) const noexcept;
  /// True if the rate is 0 in that tick.
  [[nodiscard]] bool rests(std::int64_t tick) const noexcept;
  /// True if the rate is constant from that tick on.
  [[nodiscard]] bool steady(std::int64_t tick) const noexcept { return clock_.steady(tick); }

  // ---- the place

  /// Returns the path time and rate in that tick.
  [[nodiscard]] PathTime time(std::int64_t tick) const noexcept { return clock_.at(tick); }
  /// Returns the setpoint at this path time and rate. `now` is the present moment of the axis. Call
  /// once a tick.
  Setpoint play(const PathTime& time, const Moment& now) noexcept;
  /// Confirms that the setpoint of this tick was output, so that later changes of the rate begin
  /// after this tick.
  void put_out(std::int64_t tick) noexcept;
  /// True if no more than the first point was played.
  [[nodiscard]] bool unplayed() const noexcept { return played_to_ == 0; }
  /// Returns the path time (s), after the path time of the last setpoint and up to `to`, at which
  /// the master of the path passes `position` (m, the unit of the master). Returns nullopt if the
  /// master does not pass the position.
  [[nodiscard]] std::optional<double> passing(double position, double to,
                                              const Moment& now) const noexcept;

  // ---- the boundary

  /// Ends a repeating path at the end of its present pass: sets the boundary to this end.
  void finish_pass(std::int64_t tick) noexcept;
  /// Sets the boundary at which another path takes over: the end of the present pass, or of the
  /// path.
  void swap_at_end(std::int64_t tick) noexcept;
  /// Removes the boundary.
  void forget_boundary() noexcept { boundary_ = Boundary::none; }
  /// True if another path takes over at the boundary.
  [[nodiscard]] bool swaps() const noexcept { return boundary_ == Boundary::swap; }
  /// True if the path ends at the boundary.
  [[nodiscard]] bool finishes() const noexcept { return boundary_ == Boundary::finish; }
  /// Path time of the boundary, s; infinite if the boundary is the end of a growing path, whose
  /// last row has not arrived yet.
  [[nodiscard]] double boundary() const noexcept;
  /// True if path time has reached the boundary in that tick.
  [[nodiscard]] bool reaches_boundary(std::int64_t tick) const noexcept;
  /// True if the path repeats its passes without end.
  [[nodiscard]] bool repeats() const noexcept {
    return path_ && std::isinf(path_->known()) && path_->pass() > 0;
  }
  /// True if the length of the path is not given in advance, as in a stream of rows: the path ends
  /// at rest with its last row, which may not have arrived yet.
  [[nodiscard]] bool open_ended() const noexcept { return path_ && path_->pass() <= 0; }

  // ---- the greatest magnitudes

  /// The greatest magnitudes of the path at rate 1.
  [[nodiscard]] const Peaks& peaks() const noexcept { return peaks_; }
  /// The greatest magnitudes of the path at the rate after the present change, but at least at
  /// rate 1. A velocity step counts as an acceleration.
  [[nodiscard]] Peaks peaks_at_rate() const noexcept;

 private:
  enum class Boundary : std::uint8_t { none, swap, finish };

  bool change(double rate, const PathRequest& request) noexcept;
  [[nodiscard]] double wanted(double rate, const Movement* next) const noexcept;
  [[nodiscard]] double slope_to(double rate, std::int64_t tick, const Peaks& added) const noexcept;
  [[nodiscard]] bool is_planned(std::int64_t tick, double rate, double times,
                                const PathRequest& request) const noexcept;

  AxisConfig config_;
  Movement* path_ = nullptr;
  Peaks peaks_;
  PathClock clock_;
  PathClock shown_ = clock_;     // the clock at the last setpoint that was output
  std::int64_t changeable_ = 0;  // the first tick in which the clock may still be changed
  double played_to_ = 0;         // path time of the last setpoint, s
  Boundary boundary_ = Boundary::none;
  double boundary_at_ = 0;  // path time of the boundary, s
};

}  // namespace jounce
