// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/direct.hpp"

#include <array>
#include <string>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/synchronise.hpp"

namespace jounce {

std::vector<Trajectory> direct(const Point& from, const Point& to,
                               const std::vector<Limits>& limits, DirectMode mode) {
  const std::size_t n = limits.size();
  if (n < 1 || n > max_axes)
    throw InputError("axes", std::to_string(n), "must be 1 to " + std::to_string(max_axes));
  std::array<AxisMove, max_axes> moves{};
  std::array<Profile, max_axes> profiles{};
  bool any = false;
  for (std::size_t i = 0; i < n; ++i) {
    require_valid(limits[i]);
    const std::string key = "to[" + std::to_string(i + 1) + "]";
    require_finite(key.c_str(), to[i]);
    require_finite(key.c_str(), from[i]);
    AxisMove& move = moves[i];
    move.enabled = from[i] != to[i];
    any = any || move.enabled;
    move.from.position = from[i];
    move.to.position = to[i];
    move.bounds = within(limits[i].velocity.value_or(Bounds::none),
                         limits[i].acceleration.value_or(Bounds::none),
                         limits[i].jerk.value_or(Bounds::none));
    move.bounds.position_min = limits[i].position_min.value_or(-Bounds::none);
    move.bounds.position_max = limits[i].position_max.value_or(Bounds::none);
  }
  if (!any) throw InputError("to", to[0], "is the start; there is no move");
  const Synchronised result =
      synchronise(std::span(moves).first(n), mode == DirectMode::fast ? Sync::none : Sync::phase,
                  std::span(profiles).first(n));
  if (result.status != MoveStatus::ok)
    throw InputError("to[" + std::to_string(result.axis + 1) + "]", to[result.axis],
                     explain(result.status));
  std::vector<Trajectory> axes;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Segment> segments;
    double time = 0;
    if (moves[i].enabled) {
      const Trajectory moving = profiles[i].curve();
      segments.assign(moving.segments().begin(), moving.segments().end());
      time = moving.end();
    }
    // The rest of the common duration; less than its rounding is none.
    if (result.duration - time > 1e-14 * result.duration)
      segments.push_back(line(result.duration - time, to[i], to[i]));
    axes.emplace_back(std::move(segments), 0, Extrapolation::hold);
  }
  return axes;
}

}  // namespace jounce
