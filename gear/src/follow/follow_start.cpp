// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/follow_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// The instants between which the motion stays on one side of a level, or on it.
std::vector<double> instants(const Trajectory& master, double level) {
  std::vector<double> all = crossings(master, 0, level);
  all.insert(all.end(), master.breaks().begin(), master.breaks().end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The part of the motion from t on, at its own times.
Trajectory tail(const Trajectory& f, double t) {
  const auto breaks = f.breaks();
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    if (breaks[i + 1] <= t) continue;
    const double s = (t - breaks[i]) / f.segments()[i].length;
    segments.push_back(s > 0 && s < 1 ? part(f.segments()[i], s, 1) : f.segments()[i]);
  }
  return Trajectory(
      std::move(segments), t,
      f.outside() == Extrapolation::hold ? Extrapolation::hold : Extrapolation::refuse);
}

}  // namespace

void require_valid(const FollowStart& start) {
  require_finite("position", start.position);
  if (std::abs(start.direction) != 1)
    throw InputError("direction", start.direction, "must be 1 or -1");
}

std::optional<double> begin_of(const FollowStart& start, const Trajectory& master, double armed) {
  require_valid(start);
  require_finite("armed", armed);
  if (start.event == FollowEvent::start) return armed;
  const std::vector<double> all = instants(master, start.position);
  const double rounding =
      1e-14 * std::max(std::abs(extrema(master, 0).peak().value), std::abs(start.position));
  bool beyond = start.direction * (master.at(all.front()).position - start.position) > rounding;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const double middle = master.at(all[i] + (all[i + 1] - all[i]) / 2).position;
    const bool before =
        std::exchange(beyond, start.direction * (middle - start.position) > rounding);
    if (beyond && !before && all[i] >= armed) return all[i];
  }
  return std::nullopt;
}

std::optional<Sample> begin_of(const FollowStart& start, const Sample& before, const Sample& now) {
  if (start.event == FollowEvent::start) return now;
  const auto beyond = [&](const Sample& s) {
    return start.direction * (s.master[0] - start.position) > 0;
  };
  if (beyond(before) || !beyond(now)) return std::nullopt;
  if (before.master[0] == start.position) return before;
  return passing(before, now, start.position);
}

Followed followed_from(const Cam& cam, const Trajectory& master, double t, double slave) {
  if (!(t >= master.start() && t < master.end()))
    throw InputError("t", t, "must be within the master's motion, before its end");
  const Trajectory rest = tail(master, t);
  const double at = rest.at(t).position;
  const double begins = value(cam.segments().front(), 0);
  return {shifted(cam, 0, slave - begins), shifted(rest, 0, cam.start() - at)};
}

}  // namespace jounce
