// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/position_compare.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/live_plane_compare.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;
using profiles_detail::two_roundings;

constexpr double ns = 1e-9;  ///< s

std::string key_of(std::size_t i, const char* field) {
  return "points[" + std::to_string(i + 1) + "]." + field;
}

bool pulses(CompareMode mode) {
  return mode == CompareMode::fifo_time || mode == CompareMode::linear;
}

bool holds(CompareMode mode) {
  return mode == CompareMode::equal || mode == CompareMode::less || mode == CompareMode::greater;
}

}  // namespace

void require_valid(const PositionCompare& compare) {
  if (compare.points.empty()) throw InputError("points", "", "are missing: give at least one");
  if (holds(compare.mode) && compare.points.size() > 1)
    throw InputError("points", std::to_string(compare.points.size()),
                     "must be one: this mode compares with one position");
  for (std::size_t i = 0; i < compare.points.size(); ++i)
    require_finite(key_of(i, "position").c_str(), compare.points[i].position);
  if (pulses(compare.mode))
    require_positive("pulse", compare.pulse);
  else if (compare.pulse != 0)
    throw InputError("pulse", compare.pulse, "needs a mode with pulses: this mode sets a level");
}

namespace {

void require_one_pass(const Trajectory& motion) {
  if (repeats(motion.outside()))
    throw InputError("motion", name(motion.outside()),
                     "has no last pass: use as many passes as the axis runs");
}

/// A walk along a motion, only forward, from the instant of one point to that of the next.
class Walk {
 public:
  explicit Walk(const Trajectory& motion) : motion_(motion) {}

  /// Moves to the first instant from here on at which the motion is at `level`.
  std::optional<double> to(double level) {
    for (; i_ < motion_.segments().size(); ++i_, s_ = 0) {
      const Segment& f = motion_.segments()[i_];
      const double flat = two_roundings * (magnitude(f) + std::abs(level));
      const double here = value(f, s_) - level;
      const bool passed = side_ && *side_ * here < 0;  // at the previous break, missed by rounding
      side_ = here;
      if (std::abs(here) <= flat || passed) return arrive(s_);
      if (const auto s = after(f, level, flat)) return arrive(*s);
      side_ = value(f, 1) - level;
      if (std::abs(*side_) <= flat) return arrive(1);
    }
    return std::nullopt;
  }

 private:
  std::optional<double> after(const Segment& f, double level, double flat) {
    Segment g = f;
    g.c[0] -= level;
    roots(g, flat, found_);
    const auto next = std::upper_bound(found_.begin(), found_.end(), s_);
    if (next == found_.end()) return std::nullopt;
    return *next;
  }

  double arrive(double s) {
    s_ = s;
    side_.reset();
    return s == 1 ? motion_.breaks()[i_ + 1]
                  : motion_.breaks()[i_] + s * motion_.segments()[i_].length;
  }

  const Trajectory& motion_;
  std::size_t i_ = 0;
  double s_ = 0;
  std::optional<double> side_;
  std::vector<double> found_;
};

bool met_at_start(const PositionCompare& compare, const Trajectory& motion) {
  const double past = motion.jet(motion.start())[0] - compare.points.front().position;
  return (compare.mode == CompareMode::less && past < 0) ||
         (compare.mode == CompareMode::greater && past > 0);
}

std::vector<CompareEvent> events_of(const PositionCompare& compare, const Trajectory& motion) {
  Walk walk(motion);
  std::vector<CompareEvent> events;
  for (std::size_t i = 0; i < compare.points.size(); ++i) {
    const double position = compare.points[i].position;
    const auto t = met_at_start(compare, motion) ? motion.start() : walk.to(position);
    if (!t) break;
    const Side side = *t == motion.end() ? Side::left : Side::right;
    events.push_back({*t, i, position, motion.jet(*t, side)[1]});
  }
  return events;
}

/// After the end of the motion, its last position.
double position_at(const Trajectory& motion, double time) {
  return time < motion.end() ? motion.jet(time)[0] : motion.jet(motion.end(), Side::left)[0];
}

std::vector<OutputEdge> edges_of(const PositionCompare& compare, const Trajectory& motion,
                                 const std::vector<CompareEvent>& events) {
  std::vector<OutputEdge> edges;
  const bool met = met_at_start(compare, motion);
  for (const CompareEvent& event : events) {
    const bool on = edges.empty() ? false : edges.back().on;
    const double place = met ? position_at(motion, event.time) : event.position;
    if (pulses(compare.mode)) {
      if (!edges.empty() && event.time <= edges.back().time)
        edges.pop_back();  // the previous pulse is still on: both become one longer pulse
      else
        edges.push_back({event.time, true, place});
      const double end = event.time + compare.pulse;
      edges.push_back({end, false, position_at(motion, end)});
    } else if (const bool level = compare.points[event.point].level; level != on) {
      edges.push_back({event.time, level, place});
    }
  }
  return edges;
}

}  // namespace

std::vector<ComparePoint> evenly(double start, double increment, std::size_t count) {
  require_finite("start", start);
  require_finite("increment", increment);
  if (increment == 0 && count > 1)
    throw InputError("increment", increment, "must not be 0: all points would coincide");
  std::vector<ComparePoint> points;
  for (std::size_t i = 0; i < std::max<std::size_t>(count, 1); ++i)
    points.push_back({start + static_cast<double>(i) * increment, true});
  return points;
}

Compared compared(const PositionCompare& compare, const Trajectory& motion) {
  require_valid(compare);
  require_one_pass(motion);
  Compared all;
  all.events = events_of(compare, motion);
  all.edges = edges_of(compare, motion, all.events);
  return all;
}

// ---- in a plane ------------------------------------------------------------------------------

void require_valid(const PlaneCompare& compare) {
  require_positive("x_band", compare.x_band);
  require_positive("y_band", compare.y_band);
  require_positive("pulse", compare.pulse);
  if (compare.points.empty()) throw InputError("points", "", "are missing: give at least one");
  for (std::size_t i = 0; i < compare.points.size(); ++i) {
    require_finite(key_of(i, "x").c_str(), compare.points[i].x);
    require_finite(key_of(i, "y").c_str(), compare.points[i].y);
  }
}

namespace {

void append(std::vector<double>& times, const Trajectory& f, double level) {
  const auto more = crossings(f, 0, level);
  times.insert(times.end(), more.begin(), more.end());
}

/// Every instant at which the condition for firing may become true.
std::vector<double> candidates(const PlaneCompare& compare, const PlaneCompare::Point& point,
                               const Trajectory& x, const Trajectory& y, double from) {
  std::vector<double> times{from};
  if (compare.equal) {
    append(times, x, point.x);
    append(times, y, point.y);
  }
  for (const double sign : {-1.0, 1.0}) {
    append(times, x, point.x + sign * compare.x_band);
    append(times, y, point.y + sign * compare.y_band);
  }
  std::erase_if(times, [from](double t) { return t < from; });
  std::sort(times.begin(), times.end());
  return times;
}

}  // namespace

std::vector<CompareEvent> compared(const PlaneCompare& compare, const Trajectory& x,
                                   const Trajectory& y) {
  require_valid(compare);
  if (std::abs(x.start() - y.start()) + std::abs(x.end() - y.end()) > rounded_sum * x.length())
    throw InputError("y", number(y.start()) + " to " + number(y.end()),
                     "must span the range of x, " + number(x.start()) + " to " + number(x.end()));
  const double end = std::min(x.end(), y.end());
  constexpr double rounding = 1e-12;
  std::vector<CompareEvent> events;
  double from = x.start();
  for (std::size_t i = 0; i < compare.points.size(); ++i) {
    const PlaneCompare::Point& point = compare.points[i];
    const auto fires = [&](double t) {
      const double at = std::min(t, end);
      const double dx = std::abs(x.jet(at, at == end ? Side::left : Side::right)[0] - point.x);
      const double dy = std::abs(y.jet(at, at == end ? Side::left : Side::right)[0] - point.y);
      const double near_x = rounding * (std::abs(point.x) + compare.x_band);
      const double near_y = rounding * (std::abs(point.y) + compare.y_band);
      const bool inside = dx <= compare.x_band + near_x && dy <= compare.y_band + near_y;
      return inside && (!compare.equal || dx <= near_x || dy <= near_y);
    };
    const auto times = candidates(compare, point, x, y, from);
    const auto t = std::find_if(times.begin(), times.end(), fires);
    if (t == times.end()) break;
    from = std::min(*t, end);
    events.push_back({from, i, point.x, x.jet(from, from == end ? Side::left : Side::right)[1]});
  }
  return events;
}

// ---- HMPL's words ----------------------------------------------------------------------------

namespace himc {

PositionCompare position_trigger(double start, double end, double interval, int pulse_width) {
  require_finite("StartPos", start);
  require_finite("EndPos", end);
  require_positive("Interval", interval);
  if (pulse_width < 20 || pulse_width > 80'000 || pulse_width % 20 != 0)
    throw InputError("PulseWidth", std::to_string(pulse_width),
                     "must be 20 to 80000 ns in steps of 20");
  const double intervals = std::floor(std::abs(end - start) / interval + rounded_input);
  if (intervals > 1e7)
    throw InputError("Interval", interval, "makes more than 1e7 triggers between start and end");
  return {
      CompareMode::linear,
      evenly(start, end < start ? -interval : interval, static_cast<std::size_t>(intervals) + 1),
      ns * pulse_width};
}

PositionCompare random_trigger(std::span<const double> positions, const std::vector<bool>& states,
                               std::size_t start_index, std::size_t end_index) {
  const std::size_t n = positions.size();
  if (n < 1 || n > 256)
    throw InputError("PosArray", std::to_string(n), "must hold 1 to 256 positions");
  if (states.size() != n)
    throw InputError("StateArray", std::to_string(states.size()),
                     "needs a state for each of the " + std::to_string(n) + " positions");
  if (start_index >= n)
    throw InputError("StartIndex", std::to_string(start_index),
                     "is beyond the last position, " + std::to_string(n - 1));
  if (end_index >= n)
    throw InputError("EndIndex", std::to_string(end_index),
                     "is beyond the last position, " + std::to_string(n - 1));
  PositionCompare compare{.mode = CompareMode::fifo_level};
  for (std::size_t i = start_index;; start_index < end_index ? ++i : --i) {
    compare.points.push_back({positions[i], states[i]});
    if (i == end_index) break;
  }
  return compare;
}

}  // namespace himc

}  // namespace jounce
