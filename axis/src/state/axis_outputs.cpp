// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/axis_outputs.hpp"

namespace jounce {

void AxisOutputs::put_out(const Movement& path, const PathTime& time, double dt,
                          bool is_group) noexcept {
  const std::span<const Jet> parts = path.parts();
  if (!parts.empty()) part_count_ = parts.size();
  for (std::size_t k = 0; k < parts.size(); ++k) parts_[k] = at_rate({0, 0, parts[k]}, time).slave;
  if (!is_group) return;
  path_outputs_.pass(path, time, dt);
  if (compares_way_) way_.pass(path, time);
}

void AxisOutputs::continue_as(const Movement& path, double shift) noexcept {
  path_outputs_.continue_as(path, shift);
  if (compares_way_) way_.continue_as(path, shift);
}

void AxisOutputs::step(const Places& at, double dt) {
  OutputPlaces places;
  places.commanded = at.commanded;
  places.actual = at.actual;
  if (at.is_group && compares_way_) places.way = {way_.length(), at.on_path ? way_.velocity() : 0};
  if (has_master_) places.master = at.master;
  for (std::size_t k = 0; k < plane_axes_.size() && plane_axes_[k] < part_count_; ++k)
    places.plane[k] = {parts_[plane_axes_[k]][0], parts_[plane_axes_[k]][1]};
  outputs_.step(places, dt);
  if (at.is_group && at.disabled) path_outputs_.off();
}

}  // namespace jounce
