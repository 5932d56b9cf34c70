// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/axis_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "path/src/tolerances.hpp"

namespace jounce {
namespace {

class Linear final : public AxisMap {
 public:
  Linear(std::size_t axes, LinearMap map) : AxisMap(axes, map.rows.size()), map_(std::move(map)) {}

  MapState jets(std::span<const Jet> point, std::span<Jet> joints) const override {
    for (std::size_t k = 0; k < this->joints(); ++k) {
      Jet sum{map_.offset[k], 0, 0, 0};
      for (std::size_t i = 0; i < axes(); ++i)
        for (std::size_t order = 0; order < sum.size(); ++order)
          sum[order] += map_.rows[k][i] * point[i][order];
      joints[k] = sum;
    }
    return MapState::ok;
  }
  [[nodiscard]] const LinearMap* linear() const override { return &map_; }

  /// Solves the normal equations by elimination with pivots.
  [[nodiscard]] std::optional<Point> tool(std::span<const double> joints) const override {
    const std::size_t n = axes();
    std::array<std::array<double, max_axes + 1>, max_axes> a{};
    for (std::size_t k = 0; k < this->joints(); ++k)
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t m = 0; m < n; ++m) a[i][m] += map_.rows[k][i] * map_.rows[k][m];
        a[i][n] += map_.rows[k][i] * (joints[k] - map_.offset[k]);
      }
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t pivot = i;
      for (std::size_t row = i + 1; row < n; ++row)
        if (std::abs(a[row][i]) > std::abs(a[pivot][i])) pivot = row;
      if (a[pivot][i] == 0) return std::nullopt;  // the joints do not move this axis
      std::swap(a[i], a[pivot]);
      for (std::size_t row = 0; row < n; ++row) {
        if (row == i) continue;
        const double factor = a[row][i] / a[i][i];
        for (std::size_t m = i; m <= n; ++m) a[row][m] -= factor * a[i][m];
      }
    }
    Point tool{};
    for (std::size_t i = 0; i < n; ++i) tool[i] = a[i][n] / a[i][i];
    return gives(tool, joints) ? std::optional(tool) : std::nullopt;
  }

 private:
  LinearMap map_;
};

}  // namespace

AxisMap::AxisMap(std::size_t axes, std::size_t joints) : axes_(axes), joints_(joints) {
  if (axes < 1 || joints < 1 || axes + joints > max_axes)
    throw InputError("joints", std::to_string(joints),
                     "must be at least 1, and at most " + std::to_string(max_axes) +
                         " together with the " + std::to_string(axes) + " axes of the tool");
}

AxisMap::~AxisMap() = default;

double AxisMap::turn(std::size_t) const {
  return 0;
}

bool AxisMap::bounds(std::span<const Segment>, std::span<JointBounds>) const {
  return false;
}

std::optional<Point> AxisMap::tool(std::span<const double>) const {
  return std::nullopt;
}

bool AxisMap::gives(const Point& tool, std::span<const double> joints) const {
  std::array<Jet, max_axes> point{};
  std::array<Jet, max_axes> given{};
  double scale = 1;
  for (std::size_t i = 0; i < axes(); ++i) {
    point[i] = {tool[i], 0, 0, 0};
    scale = std::max(scale, std::abs(tool[i]));
  }
  if (jets(std::span(point).first(axes()), std::span(given).first(joints_)) != MapState::ok)
    return false;
  for (std::size_t k = 0; k < joints_; ++k) {
    double off = given[k][0] - joints[k];
    if (const double period = turn(k); period > 0) off -= period * std::round(off / period);
    if (!(std::abs(off) <= path_detail::same_joint * std::max(scale, std::abs(joints[k]))))
      return false;
  }
  return true;
}

const LinearMap* AxisMap::linear() const {
  return nullptr;
}

std::shared_ptr<const AxisMap> linear_map(std::size_t axes, LinearMap map) {
  if (map.offset.empty()) map.offset.assign(map.rows.size(), 0.0);
  if (map.offset.size() != map.rows.size())
    throw InputError("offset", std::to_string(map.offset.size()), "must have one number a joint");
  for (const double x : map.offset) require_finite("offset", x);
  for (const Point& row : map.rows)
    for (std::size_t i = 0; i < max_axes; ++i)
      if (!std::isfinite(row[i]) || (i >= axes && row[i] != 0))
        throw InputError("rows", row[i], i < axes ? "must be finite" : "is beyond the axes");
  return std::make_shared<Linear>(axes, std::move(map));
}

std::shared_ptr<const AxisMap> gantry_map(std::size_t axes, std::span<const std::size_t> axis_of) {
  LinearMap map;
  for (const std::size_t axis : axis_of) {
    if (axis >= axes)
      throw InputError("axis", std::to_string(axis), "must be one of the axes of the tool");
    map.rows.emplace_back()[axis] = 1;
  }
  return linear_map(axes, std::move(map));
}

std::shared_ptr<const AxisMap> identity_map(std::size_t axes) {
  std::vector<std::size_t> same;
  for (std::size_t i = 0; i < axes; ++i) same.push_back(i);
  return gantry_map(axes, same);
}

std::shared_ptr<const AxisMap> core_xy_map(std::size_t axes) {
  if (axes < 2) throw InputError("axes", std::to_string(axes), "must be two or more for CoreXY");
  LinearMap map;
  map.rows.push_back({1, 1});
  map.rows.push_back({1, -1});
  for (std::size_t i = 2; i < axes; ++i) map.rows.emplace_back()[i] = 1;
  return linear_map(axes, std::move(map));
}

}  // namespace jounce
