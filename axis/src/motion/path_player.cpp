// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/path_player.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jounce {

void PathPlayer::begin(Movement& path, std::int64_t tick, double rate, double ahead) noexcept {
  path_ = &path;
  peaks_ = path.peaks();
  boundary_ = Boundary::none;
  played_to_ = 0;
  const double first = wanted(rate, nullptr);
  const double start = path.growing() ? std::min(first, 1.0) : first;
  clock_.start(tick, ahead * start, start);
  shown_ = clock_;
  changeable_ = tick;
}

void PathPlayer::take_over(Movement& path, std::int64_t tick, double boundary) noexcept {
  path_ = &path;
  peaks_ = path.peaks();
  boundary_ = Boundary::none;
  clock_.shift(boundary);
  shown_ = clock_;
  changeable_ = tick;
}

void PathPlayer::end() noexcept {
  path_ = nullptr;
  boundary_ = Boundary::none;
}

// ---- the rate ----------------------------------------------------------------------------------

bool PathPlayer::follow(const PathRequest& request) noexcept {
  return change(granted(request.rate, request.next), request);
}

bool PathPlayer::change(double rate, const PathRequest& request) noexcept {
  if (rate == clock_.target()) return true;
  if (rate == 0) return stop(request);
  return clock_.change(request.tick, rate, slope_to(rate, request.tick, request.added));
}

/// Starts a stop. A growing path must be available as far as the stop needs it. After a late cycle,
/// a stop that begins in this tick may need more; it then begins in the last stepped tick.
/// starves() has kept enough path for that.
bool PathPlayer::stop(const PathRequest& request) noexcept {
  const std::int64_t tick = request.tick;
  PathClock now = clock_;
  const bool can = now.target() == 0 || now.change(tick, 0, slope_to(0, tick, request.added));
  const double rest = now.at(tick).s + now.way_to_rest(tick, 0);
  const bool reaches = !path_->growing() || rest <= path_->known();
  if (can && reaches) clock_ = now;
  if (reaches) return can;
  clock_ = shown_;
  return clock_.target() == 0 ||
         clock_.change(changeable_, 0, slope_to(0, changeable_, request.added));
}

/// Sets the rate of a growing path above full speed (rate 1). It keeps such a rate only as long as
/// the available part suffices to return to full speed and then to rest. A slow supply therefore
/// slows the path to full speed first; only there is it an underrun. The new rate is the requested
/// one. If 1.5 times the path time that it needs is not available, half of the increase is tried,
/// then half of that, and so on. The margin prevents oscillation.
void PathPlayer::govern(const PathRequest& request) noexcept {
  if (request.rate <= 1) return;
  const double most = wanted(request.rate, request.next);
  if (most <= 1) return;
  if (!path_->growing()) {
    follow(request);
    return;
  }
  const double rate = clock_.target();
  if (rate > 1 && !is_planned(request.tick + 1, 1, 1, request)) change(1, request);
  if (rate < 1 || !steady(request.tick)) return;
  constexpr double least = 1.0 / 64;
  for (double more = most; more - rate > least; more = (more + rate) / 2)
    if (is_planned(request.tick, more, 1.5, request)) {
      change(more, request);
      return;
    }
}

bool PathPlayer::starves(const PathRequest& request) const noexcept {
  if (request.rate == 0) return false;
  if (path_->progress() == Progress::starving) return true;
  if (!path_->growing()) return false;
  const std::int64_t next = request.tick + 1;
  const double slope = slope_to(0, request.tick, request.added);
  const double rest = clock_.at(next).s + clock_.way_to_rest(next, slope);
  return path_->known() < rest + 1e-3 * seconds(config_.period);  // rounding
}

/// True if `times` times the path time is available that a run at `rate` takes to full speed and to
/// rest.
bool PathPlayer::is_planned(std::int64_t tick, double rate, double times,
                            const PathRequest& request) const noexcept {
  const double way = clock_.way_by(tick, rate, slope_to(rate, request.tick, request.added));
  return path_->known() >= clock_.at(tick).s + times * way + 1e-3 * seconds(config_.period);
}

/// The requested rate, at most the highest one of this path, and of the next one.
double PathPlayer::wanted(double rate, const Movement* next) const noexcept {
  const double most = std::min(highest_rate(peaks_, config_), path_->highest_rate());
  return std::min({rate, most, next ? highest_rate(next->peaks(), config_) : most});
}

/// Above full speed, govern() sets the rate of a growing path. A path that is about to be swapped
/// for a growing one first returns to full speed.
double PathPlayer::granted(double rate, const Movement* next) const noexcept {
  const double most = wanted(rate, next);
  if (most <= 1) return most;
  if (next && next->growing()) return 1;
  return path_->growing() ? std::clamp(clock_.target(), 1.0, most) : most;
}

/// The slope of a change to that rate from that tick on.
double PathPlayer::slope_to(double rate, std::int64_t tick, const Peaks& added) const noexcept {
  const double highest = std::max({1.0, clock_.highest(tick), rate});
  return std::min(rate_slope(peaks_, config_, highest, added), path_->rate_slope(highest));
}

bool PathPlayer::rests(std::int64_t tick) const noexcept {
  return clock_.target() == 0 && steady(tick);
}

Peaks PathPlayer::peaks_at_rate() const noexcept {
  const double r = std::max(1.0, clock_.target());
  const double kinks = peaks_.velocity_step / seconds(config_.period);
  return {peaks_.velocity * r, std::max(peaks_.acceleration, kinks) * r * r,
          peaks_.jerk * r * r * r};
}

// ---- the place ---------------------------------------------------------------------------------

Setpoint PathPlayer::play(const PathTime& time, const Moment& now) noexcept {
  played_to_ = time.s;
  return at_rate(path_->at({time.s, now.dt, now.master}), time);
}

void PathPlayer::put_out(std::int64_t tick) noexcept {
  shown_ = clock_;
  changeable_ = tick + 1;
}

/// By bisection. At the end of a pass the master jumps to its beginning: that jump passes nothing.
std::optional<double> PathPlayer::passing(double position, double to,
                                          const Moment& now) const noexcept {
  const auto beyond = [&](double s) {
    return path_->at({s, now.dt, now.master}).master - position;
  };
  const auto crossing = [&](double low, double high) -> std::optional<double> {
    const double before = beyond(low);
    const double after = beyond(high);
    if (!(before * after <= 0 && before != after)) return std::nullopt;
    if (before == 0) return low;
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      ((beyond(middle) < 0) == (before < 0) ? low : high) = middle;
    }
    return high;
  };
  const double pass = path_->pass();
  const double leap = pass * std::floor(to / pass);
  if (!std::isinf(path_->known()) || !(leap > played_to_)) return crossing(played_to_, to);
  const auto there = crossing(played_to_, std::nextafter(leap, 0));
  return there ? there : crossing(leap, to);
}

// ---- the boundary ------------------------------------------------------------------------------

void PathPlayer::finish_pass(std::int64_t tick) noexcept {
  boundary_ = Boundary::finish;
  boundary_at_ = path_->pass() * (std::floor(clock_.at(tick).s / path_->pass()) + 1);
}

void PathPlayer::swap_at_end(std::int64_t tick) noexcept {
  boundary_ = Boundary::swap;
  const double pass = path_->pass();
  const bool repeats = std::isinf(path_->known());
  boundary_at_ = !path_->end() ? std::numeric_limits<double>::infinity()
                 : repeats     ? pass * (std::floor(clock_.at(tick).s / pass) + 1)
                               : pass;
}

/// Until the end of an open path is available, rows may be added.
double PathPlayer::boundary() const noexcept {
  return swaps() && open_ended() && !path_->growing() ? path_->known() : boundary_at_;
}

bool PathPlayer::reaches_boundary(std::int64_t tick) const noexcept {
  return boundary_ != Boundary::none && clock_.at(tick).s >= boundary();
}

}  // namespace jounce
