// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/live_plane_compare.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/cycle_motion.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

// The rule of compared(): the condition of a point can become true only where one axis reaches the point or
// the edge of its band, or at once.

namespace jounce {
namespace {

constexpr std::size_t most_candidates = 32;  // six levels, at most three roots of a cubic each

/// The motion of an axis since the previous step; a straight line if a velocity is not known.
Segment motion(const LivePlaneCompare::Place& from, const LivePlaneCompare::Place& to, double dt) {
  if (!std::isfinite(from.velocity + to.velocity)) return line(dt, from.position, to.position);
  return cycle_motion(from.position, from.velocity, to.position, to.velocity, dt);
}

}  // namespace

LivePlaneCompare::LivePlaneCompare(const PlaneCompare& compare) : compare_(compare) {
  require_valid(compare);
  for (std::size_t i = 0; i < compare.points.size(); ++i) {
    const int output = compare.points[i].output;
    if (output < 1 || output > 32)
      throw InputError("point[" + std::to_string(i + 1) + "].output", std::to_string(output),
                       "must be 1 to 32");
  }
  found_.reserve(most_candidates);
  roots_.reserve(most_candidates);
}

void LivePlaneCompare::arm() {
  armed_ = true;
  next_ = 0;
}

const PlaneStep& LivePlaneCompare::step(const Place& x, const Place& y, double dt) {
  assert(dt > 0);
  elapsed_ += dt;
  step_.count = step_.lost = 0;
  if (std::isfinite(x.position) && std::isfinite(y.position)) {
    of_x_ = motion(placed_ ? x_ : x, x, elapsed_);
    of_y_ = motion(placed_ ? y_ : y, y, elapsed_);
    s_ = placed_ ? 0 : 1;
    placed_ = true;
    x_ = x;
    y_ = y;
    const double skipped = elapsed_ - dt;
    while (armed_ && next_ < compare_.points.size()) {
      const PlaneCompare::Point& point = compare_.points[next_];
      const auto s = reach(point);
      if (!s) break;
      s_ = *s;
      ++next_;
      const double time = std::clamp(*s * elapsed_ - skipped, 0.0, std::nextafter(dt, 0));
      end_pulses(time);
      const auto bit = static_cast<std::size_t>(point.output - 1);
      if ((step_.outputs >> bit & 1U) == 0) emit(time, point.output, true);
      off_[bit] = time + compare_.pulse;
    }
    elapsed_ = 0;
  }
  end_pulses(dt);
  for (double& off : off_) off -= dt;
  return step_;
}

/// The first s at or after s_ at which the point fires.
std::optional<double> LivePlaneCompare::reach(const PlaneCompare::Point& point) {
  found_.clear();
  found_.push_back(s_);
  if (compare_.equal) {
    find(of_x_, point.x);
    find(of_y_, point.y);
  }
  for (const double sign : {-1.0, 1.0}) {
    find(of_x_, point.x + sign * compare_.x_band);
    find(of_y_, point.y + sign * compare_.y_band);
  }
  if (s_ < 1) found_.push_back(1);
  std::sort(found_.begin(), found_.end());
  const auto s = std::find_if(found_.begin(), found_.end(),
                              [&](double at) { return at >= s_ && fires(point, at); });
  return s == found_.end() ? std::nullopt : std::optional(*s);
}

/// Adds the places at which f has this value.
void LivePlaneCompare::find(const Segment& f, double level) {
  Segment g = f;
  g.c[0] -= level;
  roots(g, profiles_detail::two_roundings * (magnitude(f) + std::abs(level)), roots_);
  found_.insert(found_.end(), roots_.begin(), roots_.end());
}

bool LivePlaneCompare::fires(const PlaneCompare::Point& point, double s) const {
  using profiles_detail::rounded_input;
  const double dx = std::abs(value(of_x_, s) - point.x);
  const double dy = std::abs(value(of_y_, s) - point.y);
  const double near_x = rounded_input * (std::abs(point.x) + compare_.x_band);
  const double near_y = rounded_input * (std::abs(point.y) + compare_.y_band);
  const bool inside = dx <= compare_.x_band + near_x && dy <= compare_.y_band + near_y;
  return inside && (!compare_.equal || dx <= near_x || dy <= near_y);
}

/// Ends the pulses that end before this time, in chronological order.
void LivePlaneCompare::end_pulses(double before) {
  for (;;) {
    std::size_t first = off_.size();
    for (std::size_t k = 0; k < off_.size(); ++k) {
      const bool ends = (step_.outputs >> k & 1U) != 0 && off_[k] < before;
      if (ends && (first == off_.size() || off_[k] < off_[first])) first = k;
    }
    if (first == off_.size()) return;
    emit(std::max(off_[first], 0.0), static_cast<int>(first) + 1, false);
  }
}

void LivePlaneCompare::emit(double time, int output, bool on) {
  const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(output - 1);
  step_.outputs = on ? step_.outputs | bit : step_.outputs & ~bit;
  if (step_.count == PlaneStep::most_edges)
    ++step_.lost;
  else
    step_.edge[step_.count++] = {time, output, on};
}

}  // namespace jounce
