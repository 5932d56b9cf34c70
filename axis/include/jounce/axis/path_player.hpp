// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/axis/path_clock.hpp"

namespace jounce {

/// The state of an axis that the rate of its path depends on.
struct PathRequest {
  std::int64_t tick = 0;
  double rate = 1;                 ///< requested rate; 0: to rest on the path
  Peaks added = {};                ///< peaks of a move on top of the path
  const Movement* next = nullptr;  ///< movement with an accepted start; null: none
};

/// Plays a path: its clock, the place on it, and the boundary at which it ends early or another
/// path takes over.
///
///     PathPlayer player(config);
///     player.begin(path, tick, 1, 0);
///     player.follow({.tick = 1000, .rate = 0});                         // a hold
///     if (player.starves({.tick = tick})) ...                           // a stop is necessary now
///     const Setpoint next = player.play(player.time(tick), moment);     // once a tick
///     player.put_out(tick);                                             // that setpoint went out
///
/// - Path time never runs backwards, and the setpoint never leaves the path.
/// - The rate is at most 2 and at most what the limits leave on this path. From the accepted start
///   of another path to the swap, it keeps the limits on that path too.
/// - A growing path can stop within its available part at every tick: starves() reports the last
///   tick in which it can.
///
/// It does not own the path. Nothing allocates, locks or throws.
class PathPlayer {
 public:
  explicit PathPlayer(const AxisConfig& config) : config_(config), clock_(config.period) {}

  /// Begins a path `ahead` s before that tick, at most at the rate `rate`.
  void begin(Movement& path, std::int64_t tick, double rate, double ahead) noexcept;
  /// Continues with this path from its beginning, where the present path has reached path time
  /// `boundary`, s.
  void take_over(Movement& path, std::int64_t tick, double boundary) noexcept;
  /// Ends the path, or does nothing.
  void end() noexcept;

  [[nodiscard]] explicit operator bool() const noexcept { return path_ != nullptr; }
  [[nodiscard]] Movement* path() const noexcept { return path_; }
  [[nodiscard]] Movement* operator->() const noexcept { return path_; }

  // ---- the rate

  /// Changes to the rate that the path grants. False: it cannot, and nothing has changed.
  bool follow(const PathRequest& request) noexcept;
  /// Stops within the available path. False: it cannot.
  bool stop(const PathRequest& request) noexcept;
  /// Adapts a rate above 1 to the available part of a growing path, once a tick.
  void govern(const PathRequest& request) noexcept;
  /// True if the available part is shorter than a stop that begins in the next tick.
  [[nodiscard]] bool starves(const PathRequest& request) const noexcept;
  /// The rate that the path accepts now instead of `rate`.
  [[nodiscard]] double granted(double rate, const Movement* next) const noexcept;
  /// True if path time rests.
  [[nodiscard]] bool rests(std::int64_t tick) const noexcept;
  /// True if the rate is constant from now on.
  [[nodiscard]] bool steady(std::int64_t tick) const noexcept { return clock_.steady(tick); }

  // ---- the place

  [[nodiscard]] PathTime time(std::int64_t tick) const noexcept { return clock_.at(tick); }
  /// Returns the setpoint at this path time, at its rate. `now`: the moment of the axis.
  Setpoint play(const PathTime& time, const Moment& now) noexcept;
  /// The setpoint of this tick has gone out: later changes begin after it.
  void put_out(std::int64_t tick) noexcept;
  /// True if only the first point has been played.
  [[nodiscard]] bool unplayed() const noexcept { return played_to_ == 0; }
  /// Path time, s, since the last played one and up to `to`, at which the master of the path passes
  /// `position`, m; nullopt: it does not.
  [[nodiscard]] std::optional<double> passing(double position, double to,
                                              const Moment& now) const noexcept;

  // ---- the boundary

  /// Ends a repeating path at the end of its present pass.
  void finish_pass(std::int64_t tick) noexcept;
  /// Another path takes over at the end of the present pass, or of the path.
  void swap_at_end(std::int64_t tick) noexcept;
  void forget_boundary() noexcept { boundary_ = Boundary::none; }
  [[nodiscard]] bool swaps() const noexcept { return boundary_ == Boundary::swap; }
  [[nodiscard]] bool finishes() const noexcept { return boundary_ == Boundary::finish; }
  /// Path time of the boundary, s; infinite: not available yet.
  [[nodiscard]] double boundary() const noexcept;
  [[nodiscard]] bool reaches_boundary(std::int64_t tick) const noexcept;
  /// True if the path ends with its last row, at rest: its number may not be available yet.
  [[nodiscard]] bool open_ended() const noexcept { return path_ && path_->pass() <= 0; }

  // ---- its greatest magnitudes

  /// The peaks at full speed.
  [[nodiscard]] const Peaks& peaks() const noexcept { return peaks_; }
  /// The peaks at the rate to come, and at least those at full speed; a step counts as an
  /// acceleration.
  [[nodiscard]] Peaks peaks_at_rate() const noexcept;

 private:
  enum class Boundary : std::uint8_t { none, swap, finish };

  bool change(double rate, const PathRequest& request) noexcept;
  [[nodiscard]] double wanted(double rate, const Movement* next) const noexcept;
  [[nodiscard]] double slope_to(double rate, std::int64_t tick, const Peaks& added) const noexcept;
  [[nodiscard]] bool knows(std::int64_t tick, double rate, double times,
                           const PathRequest& request) const noexcept;

  AxisConfig config_;
  Movement* path_ = nullptr;
  Peaks peaks_;
  PathClock clock_;
  PathClock shown_ = clock_;     // the clock at the last setpoint that went out
  std::int64_t changeable_ = 0;  // the first tick in which the clock may still be changed
  double played_to_ = 0;         // path time of the last setpoint, s
  Boundary boundary_ = Boundary::none;
  double boundary_at_ = 0;  // path time, s
};

}  // namespace jounce
