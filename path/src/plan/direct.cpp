// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/direct.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/synchronize.hpp"

#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"

namespace jounce {

namespace {

using profiles_detail::rounded_root;
using profiles_detail::rounded_value;

/// Appends the common motion of all axes to the segments of each axis; an axis without a distance
/// waits.
void append_moves(std::span<const AxisMove> moves, Sync sync,
                  std::vector<std::vector<Segment>>& axes) {
  std::array<Profile, max_axes> profiles{};
  const Synchronized result = synchronize(moves, sync, std::span(profiles).first(moves.size()));
  if (result.status != MoveStatus::ok)
    throw InputError("to[" + std::to_string(result.axis + 1) + "]", moves[result.axis].to.position,
                     explain(result.status));
  for (std::size_t i = 0; i < moves.size(); ++i) {
    double time = 0;
    if (moves[i].enabled) {
      const Trajectory moving = profiles[i].curve();
      axes[i].insert(axes[i].end(), moving.segments().begin(), moving.segments().end());
      time = moving.end();
    }
    // Fills the rest of the common duration, unless it is within rounding.
    const double to = moves[i].to.position;
    if (result.duration - time > rounded_value * result.duration)
      axes[i].push_back(line(result.duration - time, to, to));
  }
}

std::vector<Trajectory> trajectories(std::vector<std::vector<Segment>> axes) {
  std::vector<Trajectory> all;
  for (std::vector<Segment>& segments : axes)
    all.emplace_back(std::move(segments), 0, Extrapolation::hold);
  return all;
}

/// The segments of a trajectory before t.
std::vector<Segment> until(const Trajectory& curve, double t) {
  std::vector<Segment> out;
  for (std::size_t k = 0; k < curve.segments().size(); ++k) {
    const Segment& f = curve.segments()[k];
    const double share = (t - curve.breaks()[k]) / f.length;
    if (!(share > rounded_root)) break;
    out.push_back(share < 1 ? part(f, 0, share) : f);
  }
  return out;
}

}  // namespace

std::vector<Trajectory> direct(const Point& from, const Point& to,
                               const std::vector<Limits>& limits, DirectMode mode) {
  const std::size_t n = limits.size();
  if (n < 1 || n > max_axes)
    throw InputError("axes", std::to_string(n), "must be 1 to " + std::to_string(max_axes));
  std::array<AxisMove, max_axes> moves{};
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
    move.bounds = bounds_of(limits[i]);
  }
  if (!any) throw InputError("to", to[0], "is the start; there is no move");
  std::vector<std::vector<Segment>> axes(n);
  append_moves(std::span(moves).first(n), mode == DirectMode::fast ? Sync::none : Sync::phase,
               axes);
  return trajectories(std::move(axes));
}

std::vector<Trajectory> aborted(const Plan& plan, double t, const Point& to) {
  if (!(t >= 0 && t <= plan.duration()))
    throw InputError("t", t, "must be from 0 to " + number(plan.duration()));
  if (plan.given().fit)
    throw InputError("plan", "",
                     "has joints: on the way to a point all axes move on their own, and the joints "
                     "would leave their map. Use halted()");
  const std::size_t n = plan.path().axes();
  const PlanAxes planned = to_axes(plan);
  std::array<AxisMove, max_axes> moves{};
  std::vector<std::vector<Segment>> axes(n);
  for (std::size_t i = 0; i < n; ++i) {
    require_finite(("to[" + std::to_string(i + 1) + "]").c_str(), to[i]);
    const Motion now = planned.curves[i].at(t, Side::left);
    axes[i] = until(planned.curves[i], t);
    moves[i].from = state_of(now);
    moves[i].to.position = to[i];
    moves[i].bounds = bounds_of(plan.given().limits.axes[i]);
  }
  append_moves(std::span(moves).first(n), Sync::time, axes);
  return trajectories(std::move(axes));
}

Plan direct_plan(const Point& from, const Point& to, const std::vector<Limits>& limits,
                 std::size_t path_axes) {
  const std::vector<Trajectory> motions = direct(from, to, limits);
  const std::size_t n = motions.size();
  const std::size_t measured = path_axes == 0 ? n : path_axes;
  double length = vec::distance(from, to, measured);
  if (length == 0) length = vec::distance(from, to, n);
  std::vector<double> breaks;
  for (const Trajectory& motion : motions)
    breaks.insert(breaks.end(), motion.breaks().begin(), motion.breaks().end());
  std::sort(breaks.begin(), breaks.end());
  const double duration = breaks.back();
  const double speed = length / duration;
  std::vector<PathPiece> pieces;
  std::vector<double> numbers;
  double begin = 0;
  for (const double end : breaks) {
    const double h = end - begin;
    if (!(h > rounded_value * duration)) continue;  // breaks of several axes at one time
    PathPiece& piece = pieces.emplace_back();
    piece.start = begin * speed;
    piece.length = h * speed;
    piece.data = next_index(numbers);
    piece.line = 1;
    piece.kind = PieceKind::curve;
    constexpr double degree = 3;
    numbers.push_back(degree);
    for (const Trajectory& motion : motions) {
      const Jet at = motion.jet(begin);
      const double jerk = motion.jet(begin + h / 2)[3];
      numbers.insert(numbers.end(), {at[0], at[1] * h, at[2] * h * h / 2, jerk * h * h * h / 6});
    }
    begin = end;
  }
  const LawInterval even{.length = speed * duration,
                         .v0 = speed,
                         .peak = speed,
                         .v1 = speed,
                         .duration = duration,
                         .pieces = static_cast<std::uint32_t>(pieces.size())};
  Plan::Given given;
  given.limits.axes = limits;
  given.settings.emplace_back();
  given.path_axes = measured;
  return {Path(n, std::move(pieces), std::move(numbers)),
          TimingLaw({even}),
          {},
          duration,
          std::move(given)};
}

}  // namespace jounce
