// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/machine.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr Jet lost{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};

void require_names(const std::vector<MachineAxis>& axes) {
  std::set<std::string> seen;
  for (const MachineAxis& axis : axes) {
    if (axis.name.empty())
      throw InputError("name", "", "is missing: each axis of a machine needs a name");
    if (!seen.insert(axis.name).second)
      throw InputError("name", axis.name,
                       "is the name of two axes of the machine: rename one of them");
  }
}

void require_one_period(const std::vector<MachineAxis>& axes) {
  const std::int64_t period = axes.front().config.period;
  for (const MachineAxis& axis : axes)
    if (axis.config.period != period)
      throw InputError(axis.name + ".cycle", static_cast<double>(axis.config.period) * 1e-9,
                       "must be " + number(static_cast<double>(period) * 1e-9) +
                           " s, the cycle of " + axes.front().name +
                           ": all axes of a machine have the same cycle");
}

void require_leaders(const std::vector<MachineAxis>& axes, std::size_t masters) {
  using What = Follow::What;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto [what, index] = axes[i].follow;
    if (what == What::nothing) continue;
    if (index >= (what == What::master ? masters : axes.size()))
      throw InputError(
          axes[i].name + ".follow", static_cast<double>(index),
          what == What::master ? "the machine has no such master" : "the machine has no such axis");
    if (what != What::master && index == i)
      throw InputError(axes[i].name + ".follow", axes[i].name, "an axis cannot follow itself");
  }
}

/// Leaders first, otherwise in declared order: each axis comes after its chain of leaders.
std::vector<std::size_t> order_of(const std::vector<MachineAxis>& axes) {
  std::vector<std::size_t> order;
  std::vector<bool> placed(axes.size(), false);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    std::vector<std::size_t> chain;
    for (std::size_t k = i; !placed[k]; k = axes[k].follow.index) {
      if (std::find(chain.begin(), chain.end(), k) != chain.end())
        throw InputError(axes[k].name + ".follow", axes[axes[k].follow.index].name,
                         "the axes follow each other in a ring: let one of them follow no axis");
      chain.push_back(k);
      if (axes[k].follow.what != Follow::What::setpoint) break;
    }
    for (auto k = chain.rbegin(); k != chain.rend(); ++k) {
      order.push_back(*k);
      placed[*k] = true;
    }
  }
  return order;
}

std::vector<MachineAxis> checked(std::vector<MachineAxis> axes, std::size_t masters) {
  if (axes.empty()) throw InputError("axes", "", "are missing: a machine needs at least one axis");
  if (axes.size() > Machine::most_axes)
    throw InputError("axes", static_cast<double>(axes.size()),
                     "must be at most 64, the greatest number of axes of a machine");
  require_names(axes);
  require_one_period(axes);
  require_leaders(axes, masters);
  return axes;
}

/// True if another axis has broken the group: in this tick if it was stepped earlier, otherwise in
/// an earlier tick.
bool is_broken(std::int64_t group, std::size_t axis, std::span<const AxisImage> images) {
  for (std::size_t k = 0; k < images.size() && group != 0; ++k) {
    const auto& broken = images[k].tick.broken;
    if (k != axis && std::find(broken.begin(), broken.end(), group) != broken.end()) return true;
  }
  return false;
}

/// True if, after the previous tick, not all axes armed in the group have a start for the same
/// tick.
bool is_incomplete(std::size_t axis, std::span<const AxisImage> images) {
  const GroupStart& own = images[axis].tick.next;
  for (std::size_t k = 0; k < images.size() && own.group != 0; ++k) {
    const GroupStart& other = images[k].tick.next;
    const bool together = own.accepted && other.accepted && own.tick == other.tick;
    if (k != axis && own.group == other.group && !together) return true;
  }
  return false;
}

}  // namespace

Machine::Machine(std::vector<MachineAxis> axes, std::size_t masters)
    : axes_(checked(std::move(axes), masters)), masters_(masters), order_(order_of(axes_)) {
  motion_.reserve(axes_.size());
  for (const MachineAxis& axis : axes_)
    motion_.emplace_back(axis.config, axis.switches, axis.compare);
}

void Machine::step(std::int64_t tick, std::span<AxisImage> images, std::span<const Jet> masters) {
  assert(images.size() == axes_.size() && masters.size() == masters_);
  // Before the first axis is stepped: if one begins, all begin.
  for (std::size_t i = 0; i < images.size(); ++i)
    images[i].inputs.peers = is_incomplete(i, images) ? Peers::missing : Peers::ready;
  for (const std::size_t i : order_) {
    AxisImage& image = images[i];
    image.inputs.master = master_of(i, images, masters);
    image.inputs.master_offset = master_offset_of(i, images);
    image.inputs.group_broken = is_broken(image.tick.group, i, images);
    if (is_broken(image.tick.next.group, i, images)) image.inputs.peers = Peers::broken;
    image.tick = motion_[i].step(tick, image.command, image.inputs);
  }
}

Jet Machine::master_of(std::size_t axis, std::span<const AxisImage> images,
                       std::span<const Jet> masters) const {
  const auto [what, index] = axes_[axis].follow;
  switch (what) {
    case Follow::What::nothing:
      break;
    case Follow::What::master:
      return masters[index];
    case Follow::What::setpoint: {
      const Tick& leader = images[index].tick;
      // It froze, or has the position of its drive: its followers must not follow that jump.
      if (leader.frozen || leader.state == State::disabled) break;
      return {leader.position, leader.velocity, leader.acceleration, 0};
    }
    case Follow::What::actual: {
      const Feedback& leader = images[index].inputs.feedback;
      if (!std::isfinite(leader.position) || !std::isfinite(leader.velocity)) break;
      return {leader.position, leader.velocity, 0, 0};
    }
  }
  return lost;
}

double Machine::master_offset_of(std::size_t axis, std::span<const AxisImage> images) const {
  const auto [what, index] = axes_[axis].follow;
  return what == Follow::What::setpoint ? images[index].tick.offset : 0;
}

}  // namespace jounce
