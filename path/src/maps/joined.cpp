// SPDX-License-Identifier: Apache-2.0
#include "path/src/maps/joined.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "path/src/geometry/pieces.hpp"
#include "path/src/maps/fitted_joints.hpp"
#include "path/src/maps/joints_at.hpp"

namespace jounce {
namespace {

GroupLimits all_limits(const GroupLimits& limits, const std::optional<JointSpace>& joints) {
  GroupLimits all = limits;
  if (joints) all.axes.insert(all.axes.end(), joints->limits.begin(), joints->limits.end());
  return all;
}

void require_fitting_joints(const Program& program, const JointSpace& joints) {
  if (!joints.map) throw InputError("joints", "", "need a map");
  require_positive("tolerance", joints.tolerance);
  if (joints.map->axes() > program.axes())
    throw InputError("axes", std::to_string(program.axes()),
                     "must be at least " + std::to_string(joints.map->axes()) +
                         ", the axes that the map of the joints reads");
  if (joints.limits.size() != joints.map->joints())
    throw InputError(
        "joints", std::to_string(joints.limits.size()),
        "needs limits for each of the " + std::to_string(joints.map->joints()) + " joints");
  if (program.axes() + joints.map->joints() > max_axes)
    throw InputError("joints", std::to_string(joints.map->joints()),
                     "must be at most " + std::to_string(max_axes) + " together with the " +
                         std::to_string(program.axes()) + " axes of the program");
}

/// Appends n numbers of a piece and those of the joints; for positions, the offset of the map is
/// added.
void append_joined(const double* values, std::size_t stride, std::size_t n, const LinearMap& map,
                   bool position, std::vector<double>& out) {
  for (std::size_t i = 0; i < n; ++i) out.push_back(values[i * stride]);
  for (std::size_t k = 0; k < map.rows.size(); ++k) {
    double sum = position ? map.offset[k] : 0;
    for (std::size_t i = 0; i < n; ++i) sum += map.rows[k][i] * values[i * stride];
    out.push_back(sum);
  }
}

/// Appends the numbers of a line, an arc or a curve, all of which are linear in the axes.
void append_piece(const Path& path, std::size_t piece, const LinearMap& map,
                  std::vector<double>& out) {
  const std::size_t n = path.axes();
  const double* data = path.numbers(piece);
  switch (path.pieces()[piece].kind) {
    case PieceKind::line:
      append_joined(data, 1, n, map, true, out);
      append_joined(data + n, 1, n, map, false, out);
      return;
    case PieceKind::arc:
      for (std::size_t part = 0; part < 4; ++part)
        append_joined(data + part * n, 1, n, map, part == 0, out);
      out.insert(out.end(), {data[4 * n], data[4 * n + 1]});
      return;
    default: {
      const auto count = static_cast<std::size_t>(data[0]) + 1;
      std::vector<double> by_power;
      for (std::size_t k = 0; k < count; ++k)
        append_joined(data + 1 + k, count, n, map, k == 0, by_power);
      const std::size_t all = n + map.rows.size();
      out.push_back(data[0]);
      for (std::size_t i = 0; i < all; ++i)
        for (std::size_t k = 0; k < count; ++k) out.push_back(by_power[k * all + i]);
    }
  }
}

double median(std::vector<double>& values) {
  if (values.empty()) return PathSettings::none;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Joined::Joined(const Program& program, const GroupLimits& limits,
               const std::optional<JointSpace>& joints, const std::atomic<bool>* canceled)
    : program_(program),
      joints_(joints),
      limits_(all_limits(limits, joints)),
      tool_(rates_of(limits, program.axes(), program.path_axes())),
      rates_(tool_) {
  if (joints) {
    require_fitting_joints(program, *joints);
    rates_ = rates_of(limits_, program.axes() + joints->map->joints(), program.path_axes());
  }
  tool_.canceled = rates_.canceled = canceled;
}

Route Joined::with_linear(Route route) const {
  if (!joints_ || fitted()) return route;
  const LinearMap& map = *joints_->map->linear();
  std::vector<PathPiece> pieces(route.path.pieces().begin(), route.path.pieces().end());
  std::vector<double> numbers;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    pieces[k].data = next_index(numbers);
    append_piece(route.path, k, map, numbers);
  }
  route.path = Path(rates_.axes, std::move(pieces), std::move(numbers));
  return route;
}

Rates Joined::corner_rates(const Route& route) const {
  if (!fitted()) return rates_;
  const AxisMap& map = *joints_->map;
  Rates rates = tool_;
  constexpr std::size_t places = 64;
  // Position within a piece; not its middle, which may be the base of a robot.
  constexpr double inside = 0.382;
  const std::size_t count = route.path.pieces().size();
  const std::size_t step = std::max<std::size_t>(1, count / places);
  std::array<Jet, max_axes> joint{};
  for (std::size_t i = 0; i < map.axes(); ++i) {
    std::array<std::vector<double>, 3> seen;
    for (std::size_t k = 0; k < count; k += step) {
      const Point at = route.path.point(k, inside * route.path.pieces()[k].length);
      std::array<Jet, max_axes> point{};
      for (std::size_t m = 0; m < map.axes(); ++m) point[m] = {at[m], m == i ? 1.0 : 0.0, 0, 0};
      if (path_detail::joints_at(map, point, joint) != MapState::ok) continue;
      Point least;
      least.fill(PathSettings::none);
      for (std::size_t j = 0; j < map.joints(); ++j) {
        const std::size_t axis = tool_.axes + j;
        const double slope = std::abs(joint[j][1]);
        const double limit[] = {rates_.velocity[axis], rates_.acceleration[axis],
                                rates_.jerk[axis]};
        for (std::size_t order = 0; order < 3; ++order)
          if (slope > 0) least[order] = std::min(least[order], limit[order] / slope);
      }
      for (std::size_t order = 0; order < 3; ++order) seen[order].push_back(least[order]);
    }
    rates.velocity[i] = std::min(rates.velocity[i], median(seen[0]));
    rates.acceleration[i] = std::min(rates.acceleration[i], median(seen[1]));
    rates.jerk[i] = std::min(rates.jerk[i], median(seen[2]));
  }
  return rates;
}

Jointed Joined::with_fitted(Rounded rounded, const Route& route) const {
  if (!joints_) return {std::move(rounded), {}, {}};
  if (!fitted()) return {std::move(rounded), {}, MapFit{0, true, 0, 0}};
  Path path = rounded.path ? std::move(*rounded.path) : Path(route.path);
  return fitted_joints(std::move(path), std::move(rounded), *joints_, rates_, program_);
}

}  // namespace jounce
