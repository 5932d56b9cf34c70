// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/machine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "jounce/path/point.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// The reason why an axis of a group is not ready.
Cause unready(State state, bool lost_home) {
  switch (state) {
    case State::disabled:
      return Cause::not_enabled;
    case State::error_stop:
      return Cause::in_error;
    case State::stopping:
      return Cause::stopping;
    default:
      return lost_home ? Cause::not_homed : Cause::in_motion;
  }
}

constexpr Jet no_master{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};

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
  const auto require = [&](std::size_t i, const char* key, const Follow& follow) {
    const What what = follow.what;
    const std::size_t index = follow.index;
    if (what == What::nothing) return;
    if (index >= (what == What::master ? masters : axes.size()))
      throw InputError(
          axes[i].name + key, static_cast<double>(index),
          what == What::master ? "the machine has no such master" : "the machine has no such axis");
    if (what != What::master && index == i)
      throw InputError(axes[i].name + key, axes[i].name, "an axis cannot follow itself");
  };
  for (std::size_t i = 0; i < axes.size(); ++i) {
    require(i, ".follow", axes[i].follow);
    require(i, ".follow.second", axes[i].second);
  }
}

/// Throws InputError unless the references of each compensation are axes of the machine, and the
/// corrected axis itself at the index `own` of the table.
void require_references(const std::vector<MachineAxis>& axes) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto& compensation = axes[i].config.compensation;
    const std::vector<std::size_t>& references = axes[i].references;
    const std::string key = axes[i].name + ".compensation.reference";
    const std::size_t count = compensation ? compensation->table.axes.size() : 0;
    if (references.size() != count)
      throw InputError(key, static_cast<double>(references.size()),
                       "must be " + std::to_string(count) + " axes, as in the table");
    for (std::size_t j = 0; j < count; ++j) {
      if (references[j] >= axes.size() || axes[references[j]].group)
        throw InputError(key, static_cast<double>(references[j]), "the machine has no such axis");
      if ((references[j] == i) != (compensation->own == j))
        throw InputError(
            key, axes[references[j]].name,
            "must be the corrected axis at the index own of the table, and only there");
    }
  }
}

using Memberships = std::vector<std::optional<std::size_t>>;  ///< group of each axis

/// The group of each axis. Throws for groups that cannot be.
Memberships groups_of(const std::vector<MachineAxis>& axes) {
  Memberships groups(axes.size());
  for (std::size_t g = 0; g < axes.size(); ++g) {
    if (!axes[g].group) continue;
    const auto refuse = [&](const std::string& value, const std::string& rule) {
      throw InputError(axes[g].name + ".axes", value, rule);
    };
    const std::vector<std::size_t>& members = axes[g].group->axes;
    if (members.empty() || members.size() > max_axes)
      refuse(std::to_string(members.size()), "must be 1 to " + std::to_string(max_axes) + " axes");
    if (axes[g].follow.what != Follow::What::nothing)
      refuse(axes[g].name, "a group cannot follow a master");
    for (const std::size_t k : members) {
      if (k >= axes.size() || axes[k].group)
        refuse(k < axes.size() ? axes[k].name : std::to_string(k),
               "must be an axis of the machine, and not a group");
      if (groups[k])
        refuse(axes[k].name, "is already an axis of the group " + axes[*groups[k]].name +
                                 ": name each axis once");
      if (axes[k].follow.what != Follow::What::nothing)
        refuse(axes[k].name,
               "follows a master: an axis of a group follows only its group. Remove it from axes, "
               "or remove its follow");
      const double most = *axes[k].config.limits.velocity * seconds(axes[k].config.period);
      const double tolerance = axes[g].group->tolerance;
      if (!(tolerance >= 0))
        throw InputError(axes[g].name + ".tolerance", tolerance, "must not be negative");
      if (tolerance > most)
        throw InputError(axes[g].name + ".tolerance", tolerance,
                         "must be at most " + number(most) + ", the distance that " + axes[k].name +
                             " covers in one cycle at its velocity limit");
      groups[k] = g;
    }
  }
  return groups;
}

/// Leaders and groups first, otherwise in declared order: each axis comes after all its leaders.
class Order {
 public:
  Order(const std::vector<MachineAxis>& axes, const Memberships& groups)
      : axes_(axes), groups_(groups), placed_(axes.size(), false) {
    for (std::size_t i = 0; i < axes.size(); ++i) place(i);
  }

  std::vector<std::size_t> order;

 private:
  void place(std::size_t i) {
    if (placed_[i]) return;
    if (std::find(chain_.begin(), chain_.end(), i) != chain_.end())
      throw InputError(axes_[chain_.back()].name + ".follow", axes_[i].name,
                       "the axes follow each other in a ring: let one of them follow no axis");
    chain_.push_back(i);
    if (groups_[i]) place(*groups_[i]);
    for (const Follow& follow : {axes_[i].follow, axes_[i].second})
      if (!groups_[i] && follow.what == Follow::What::setpoint) place(follow.index);
    chain_.pop_back();
    order.push_back(i);
    placed_[i] = true;
  }

  const std::vector<MachineAxis>& axes_;
  const Memberships& groups_;
  std::vector<bool> placed_;
  std::vector<std::size_t> chain_;  // followers of the axis that is placed next
};

std::vector<MachineAxis> checked(std::vector<MachineAxis> axes, std::size_t masters) {
  if (axes.empty()) throw InputError("axes", "", "are missing: a machine needs at least one axis");
  if (axes.size() > Machine::most_axes)
    throw InputError("axes", static_cast<double>(axes.size()),
                     "must be at most 64, the greatest number of axes of a machine");
  require_names(axes);
  require_one_period(axes);
  require_leaders(axes, masters);
  require_references(axes);
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

/// The position of a leader or a master in this tick, in the unit of that leader.
Jet unscaled_master_of(const Follow& follow, std::span<const AxisImage> images,
                       std::span<const Jet> masters) {
  const std::size_t index = follow.index;
  switch (follow.what) {
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
  return no_master;
}

/// The same in the unit of the follower's master.
Jet master_of(const Follow& follow, std::span<const AxisImage> images,
              std::span<const Jet> masters) {
  Jet at = unscaled_master_of(follow, images, masters);
  for (double& value : at) value *= follow.scale;
  return at;
}

double master_offset_of(const Follow& follow, std::span<const AxisImage> images) {
  return follow.what == Follow::What::setpoint ? follow.scale * images[follow.index].tick.offset
                                               : 0;
}

/// The whole turns from a place on a path to the position of a modulo axis, u. Position limits count turns:
/// an axis with such limits has no other place.
double turns_between(double place, double position, const AxisConfig& config) {
  if (config.modulo == 0 || config.limits.position_min || config.limits.position_max) return 0;
  return std::round((position - place) / config.modulo) * config.modulo;
}

/// True for a group whose path time passes.
bool moves(const Tick& group) {
  return group.job != 0 && group.rate != 0;
}

}  // namespace

Machine::Machine(std::vector<MachineAxis> axes, std::size_t masters)
    : axes_(checked(std::move(axes), masters)),
      masters_(masters),
      memberships_(axes_.size()),
      order_(Order(axes_, groups_of(axes_)).order),
      moved_(axes_.size(), false),
      turns_(axes_.size(), 0.0) {
  for (std::size_t g = 0; g < axes_.size(); ++g)
    for (std::size_t k = 0; axes_[g].group && k < axes_[g].group->axes.size(); ++k)
      memberships_[axes_[g].group->axes[k]] = Membership{g, k};
  motion_.reserve(axes_.size());
  for (const MachineAxis& axis : axes_)
    motion_.emplace_back(axis.config, axis.switches, axis.compare);
}

void Machine::step(std::int64_t tick, std::span<AxisImage> images, std::span<const Jet> masters) {
  require_size("images", images.size(), axes_.size());
  require_size("masters", masters.size(), masters_);
  // Before the first axis is stepped: if one begins, all begin.
  for (std::size_t i = 0; i < images.size(); ++i)
    images[i].inputs.peers = is_incomplete(i, images) ? Peers::missing : Peers::ready;
  announce_references(images);
  for (const std::size_t i : order_) {
    AxisImage& image = images[i];
    image.inputs.master = master_of(axes_[i].follow, images, masters);
    image.inputs.master_offset = master_offset_of(axes_[i].follow, images);
    image.inputs.second_master = master_of(axes_[i].second, images, masters);
    image.inputs.second_offset = master_offset_of(axes_[i].second, images);
    image.inputs.group_broken = is_broken(image.tick.group, i, images);
    if (is_broken(image.tick.next.group, i, images)) image.inputs.peers = Peers::broken;
    if (axes_[i].group) gather(i, images);
    if (memberships_[i]) lead(i, *memberships_[i], images);
    image.tick = motion_[i].step(tick, image.command, image.inputs);
  }
  compensate(images);
  for (const std::size_t i : order_)
    if (axes_[i].group) moved_[i] = moves(images[i].tick);
}

/// An axis keeps its coordinate while another axis is corrected by its position.
void Machine::announce_references(std::span<AxisImage> images) const {
  for (AxisImage& image : images) image.inputs.referenced = false;
  for (std::size_t i = 0; i < images.size(); ++i)
    for (const std::size_t k : axes_[i].references)
      if (k != i && images[i].tick.compensated) images[k].inputs.referenced = true;
}

/// After the step of all axes: their setpoints of this tick are known.
void Machine::compensate(std::span<AxisImage> images) {
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::vector<std::size_t>& axes = axes_[i].references;
    if (axes.empty()) continue;
    References& references = images[i].inputs.references;
    for (std::size_t j = 0; j < axes.size(); ++j) {
      const Tick& axis = images[axes[j]].tick;
      const double turn = axes_[axes[j]].config.modulo;
      references[j] = {turn != 0 ? wrapped(axis.position, 0, turn) : axis.position, axis.velocity,
                       axis.acceleration, 0};
    }
    images[i].tick.correction = motion_[i].compensate(references);
  }
}

/// The inputs of a group before its step: can its axes follow? In motion, they follow since the
/// previous tick. At rest, they stand still. The first axis that is not in its place is named.
void Machine::gather(std::size_t group, std::span<AxisImage> images) {
  const std::span<const Jet> places = motion_[group].places();
  const AxisGroup& of = *axes_[group].group;
  const State expected = moved_[group] ? State::synchronized_motion : State::standstill;
  Inputs& inputs = images[group].inputs;
  inputs.peers = places.size() == of.axes.size() ? Peers::together : Peers::away;
  inputs.master = no_master;
  inputs.group_broken = false;
  unsigned failing = 0;  // bit k: axis k
  for (std::size_t k = 0; k < of.axes.size(); ++k) {
    const AxisImage& axis = images[of.axes[k]];
    const bool placed = places.size() == of.axes.size();
    if (!moved_[group])
      turns_[of.axes[k]] =
          placed ? turns_between(places[k][0], axis.tick.position, axes_[of.axes[k]].config) : 0;
    const double place = placed ? places[k][0] + turns_[of.axes[k]] : axis.tick.position;
    const bool lost_home = axes_[of.axes[k]].config.require_home && !axis.tick.homed;
    const bool fails = axis.tick.state != expected || axis.tick.waiting || lost_home;
    const bool away = !(std::abs(axis.tick.position - place) <= of.tolerance);
    if (fails) failing |= 1U << k;
    if (moved_[group] && axis.command.kind() == CommandKind::stop) inputs.group_broken = true;
    if (inputs.peers == Peers::failed || (!fails && (!away || inputs.peers == Peers::away)))
      continue;
    inputs.peers = fails ? Peers::failed : Peers::away;
    inputs.master = {axis.tick.position, place, static_cast<double>(k + 1),
                     static_cast<double>(unready(axis.tick.state, lost_home))};
  }
  if (inputs.peers == Peers::failed) inputs.master[1] = failing;
}

/// The inputs of an axis of a group that was stepped in this tick. The last setpoint of a motion is
/// that at rest. If the group froze in motion, its axes lose it.
void Machine::lead(std::size_t axis, const Membership& in, std::span<AxisImage> images) const {
  const Tick& group = images[in.group].tick;
  Inputs& inputs = images[axis].inputs;
  inputs.master = no_master;
  const bool moving = moves(group);
  if (moving || moved_[in.group]) {
    const bool rests = group.velocity == 0 && !group.frozen;
    inputs.peers = moving || !rests ? Peers::led : Peers::landing;
    if (moving || rests) inputs.master = motion_[in.group].parts()[in.place];
    inputs.master[0] += turns_[axis];
    return;
  }
  const bool enabled = group.state != State::disabled && group.state != State::error_stop;
  if (enabled) inputs.peers = Peers::grouped;
}

}  // namespace jounce
