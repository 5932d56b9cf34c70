// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/axis_map.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

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
