// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/sequences/override_ramp.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/sequences/retime.hpp"

// An axis f(c), played along a clock c(t):
//
//   (1)  v = f' c',   a = f'' c'^2 + f' c'',   j = f''' c'^3 + 3 f'' c' c'' + f' c'''
//
// While f cruises at v, a change of the factor within |c''| <= A / v and |c'''| <= J / v uses the
// whole A and J. With v the greatest velocity of the plan, these are the nominal bounds of a ramp.
// The ramps that are tried are k times as slow, and have different jerks at their ends:
//
//   (2)  |c''| <= A / (k v),   |c'''| <= g J / (k^2 v)
//
// k stretches a ramp without changing its shape. If f'' = 0, g = 1 is possible from k = 1 on. Early
// in an acceleration f' is small, so a sharper ramp (g > 1, k < 1) is possible. If f accelerates at
// its limit, no ramp that speeds up is possible; if f brakes at its limit, none that slows down.

namespace jounce::profiles_detail {
namespace {

constexpr int steepest = -20;  // k = 2^(-20/4) is the steepest ramp that is tried,
constexpr int slowest = 48;    // and 2^(48/4) the slowest one
struct Shape {
  double in, out;  // the two g of (2): where |c''| increases, and where it decreases
};
constexpr std::array shapes{Shape{1, 1}, Shape{4, 1},  Shape{16, 1}, Shape{64, 1},
                            Shape{4, 4}, Shape{16, 4}, Shape{64, 4}, Shape{0.25, 0.25}};
constexpr int refinements = 6;  // bisections between two values of k: to 0.3 %
constexpr int quarters = 4;     // number of starts that are tried between two breaks of the plan

/// Checks (1) at nine points inside each piece of the clock. An excess below 1e-9 of a limit is
/// left to `check`.
bool is_broken_at_points(const Trajectory& axis, const Limits& limits, const Trajectory& clock) {
  const double v = *limits.velocity * (1 + 1e-9);
  const double a = *limits.acceleration * (1 + 1e-9);
  const double j = *limits.jerk * (1 + 1e-9);
  for (const Segment& piece : clock.segments())
    for (int n = 0; n <= 8; ++n) {
      const Jet c = evaluate(piece, std::clamp(n / 8.0, 0x1p-10, 1 - 0x1p-10));
      const Jet f = axis.jet(c[0]);
      if (std::abs(f[1] * c[1]) > v || std::abs(f[2] * c[1] * c[1] + f[1] * c[2]) > a ||
          std::abs(f[3] * c[1] * c[1] * c[1] + 3 * f[2] * c[1] * c[2] + f[1] * c[3]) > j)
        return true;
    }
  return false;
}

}  // namespace

double Clock::end() const {
  double t = start;
  for (const Segment& f : pieces) t += f.length;
  return t;
}

Trajectory Clock::until(double t) const {
  auto all = pieces;
  const double rest = t - end();
  if (rest > 0) all.push_back(line(rest, path, path + rate * rest));
  const Trajectory whole(std::move(all), start, Extrapolation::hold);
  return t < whole.end() ? between(whole, start, t) : whole;
}

MotionState Clock::at(double t) const {
  if (!(t > start)) return {origin, pieces.empty() ? rate : evaluate(pieces.front(), 0)[1], 0};
  const Jet now = evaluate(until(t).segments().back(), 1);
  return {now[0], now[1], now[2]};
}

double Clock::reaches(double path_time) const {
  if (path < path_time) return rate > 0 ? end() + (path_time - path) / rate : Bounds::none;
  return crossings(until(end()), 0, path_time).front();
}

void Clock::follow(const Ramp& ramp) {
  std::vector<Segment> all;
  if (ramp.begin > start) {
    const Trajectory before = until(ramp.begin);
    all.assign(before.segments().begin(), before.segments().end());
  }
  all.insert(all.end(), ramp.pieces.begin(), ramp.pieces.end());
  pieces = std::move(all);
  path = ramp.path;
  rate = ramp.factor;
}

/// Most ramps that break a limit do so at one of a few points.
bool Path::allows(const Trajectory& clock) const {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (is_broken_at_points(axes[i], limits[i], clock)) return false;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (!check(composed(axes[i], clock), limits[i]).ok()) return false;
  return true;
}

double Path::room(double from) const {
  double k = 0;
  for (std::size_t i = 0; i < axes.size() && from < end(); ++i) {
    const Trajectory rest = between(axes[i], from, end());
    if (extrema(rest, 1).peak().value != 0) k = std::max(k, least_stretch(rest, limits[i]));
  }
  return k > 0 ? 1 / k : Bounds::none;
}

namespace {

/// The search for the answer to one request: the earliest end over all starts and steepnesses.
class FactorSearch {
 public:
  FactorSearch(const Path& path, const Clock& clock, const FactorRequest& request, double maximum)
      : path_(path),
        clock_(clock),
        request_(request),
        maximum_(maximum),
        over_(clock.reaches(path.end())) {}

  [[nodiscard]] std::optional<Ramp> run() {
    const auto starts = candidates();
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const double next = i + 1 < starts.size() ? starts[i + 1] : starts[i];
      for (int q = 0; q < quarters && (q == 0 || next > starts[i]); ++q) {
        const double t = starts[i] + q * (next - starts[i]) / quarters;
        if (t >= over_ || (best_ && t >= best_->end)) return std::move(best_);
        try_from(t);
      }
    }
    return std::move(best_);
  }

 private:
  struct Steepness {
    double k;
    Shape shape;
  };
  enum class Outcome { holds, breaks_a_limit, comes_too_late };

  /// Candidates for the start: the time of the request, and every later break of the clock and of
  /// an axis.
  [[nodiscard]] std::vector<double> candidates() const {
    std::vector<double> t{request_.time};
    double at = clock_.start;
    for (const Segment& f : clock_.pieces) t.push_back(at += f.length);
    const double reach = std::isfinite(over_) ? over_ : std::max(at, request_.time);
    if (reach > clock_.start) {
      const Trajectory clock = clock_.until(reach);
      for (const Trajectory& axis : path_.axes)
        for (const double level : axis.breaks())
          for (const double x : crossings(clock, 0, level)) t.push_back(x);
    }
    std::sort(t.begin(), t.end());
    t.erase(t.begin(), std::lower_bound(t.begin(), t.end(), request_.time));
    t.erase(std::unique(t.begin(), t.end()), t.end());
    return t;
  }

  /// Searches the steepest ramp that begins at t, unless a known ramp ends earlier.
  void try_from(double t) {
    const MotionState now = clock_.at(t);
    const double factor = request_.factor > 1
                              ? std::clamp(path_.room(now.position), 1.0, request_.factor)
                              : request_.factor;
    if (now.acceleration == 0 && std::abs(now.velocity - factor) <= 1e-14 * factor) {
      best_ = Ramp{t, t, factor, now.position, {}};
      return;
    }
    for (const Shape& shape : shapes) steepest_of(t, now, factor, shape);
  }

  /// The same for the ramps of one shape.
  void steepest_of(double t, const MotionState& now, double factor, const Shape& shape) {
    // `refused` breaks a limit; in the end `k` does not, or its ramp ends too late.
    double refused = 0;
    double k = 0;
    Outcome outcome = Outcome::breaks_a_limit;
    for (int n = steepest; outcome == Outcome::breaks_a_limit && n <= slowest; ++n) {
      refused = k;
      k = std::exp2(n / 4.0);
      outcome = attempt(t, now, factor, {k, shape});
    }
    if (outcome == Outcome::breaks_a_limit) return;
    for (int i = 0; i < refinements && refused > 0; ++i) {
      const double middle = (refused + k) / 2;
      const bool breaks = attempt(t, now, factor, {middle, shape}) == Outcome::breaks_a_limit;
      (breaks ? refused : k) = middle;
    }
  }

  /// Keeps a ramp if it holds and ends earlier than the best so far.
  Outcome attempt(double t, const MotionState& now, double factor, const Steepness& steepness) {
    const auto& [k, shape] = steepness;
    const double j = path_.jerk / (k * k);  // (2)
    Bounds bounds = within(Bounds::none, path_.acceleration / k, shape.in * j);
    (factor < now.velocity ? bounds.jerk_max : bounds.jerk_min) *= shape.out / shape.in;
    const MoveResult change = move_velocity(now, factor, bounds);
    if (!change) return Outcome::breaks_a_limit;  // numbers outside the range of a move
    const double end = t + change.profile.duration();
    const double path = change.profile.end().position;
    const bool slows_down = factor < now.velocity;
    if ((best_ && end >= best_->end) || (slows_down && path >= path_.end()) ||
        (factor == 0 && end >= over_))
      return Outcome::comes_too_late;
    const Trajectory clock = change.profile.curve();
    const Range rate = extrema(clock, 1);
    if (rate.min.value < -1e-12 || rate.max.value > maximum_ + 1e-12 || !path_.allows(clock))
      return Outcome::breaks_a_limit;
    best_ = Ramp{t, end, factor, path, {clock.segments().begin(), clock.segments().end()}};
    return Outcome::holds;
  }

  const Path& path_;
  const Clock& clock_;
  FactorRequest request_;
  double maximum_;
  double over_;  // end of the path without a change
  std::optional<Ramp> best_;
};

}  // namespace

std::optional<Ramp> earliest_ramp(const Path& path, const Clock& clock,
                                  const FactorRequest& request, double maximum) {
  return FactorSearch(path, clock, request, maximum).run();
}

}  // namespace jounce::profiles_detail
