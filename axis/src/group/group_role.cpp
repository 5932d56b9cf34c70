// SPDX-License-Identifier: Apache-2.0
#include "axis/src/group/group_role.hpp"

namespace jounce {
namespace {

/// True for the commands that an axis accepts while its group is enabled: none sets it in motion.
bool suits_member(CommandKind kind) {
  switch (kind) {
    case CommandKind::none:
    case CommandKind::enable:
    case CommandKind::disable:
    case CommandKind::disarm:
    case CommandKind::stop:
    case CommandKind::abort:
    case CommandKind::reset:
    case CommandKind::release:
    case CommandKind::touch_probe:
    case CommandKind::abort_trigger:
      return true;
    default:
      return false;
  }
}

/// True for the commands of a group.
bool suits_group(CommandKind kind) {
  switch (kind) {
    case CommandKind::arm:
    case CommandKind::start:
    case CommandKind::hold:
    case CommandKind::resume:
    case CommandKind::halt:
    case CommandKind::override_:
    case CommandKind::extend:
      return true;
    default:
      return suits_member(kind);
  }
}

}  // namespace

Cause against_role(Peers peers, CommandKind kind) noexcept {
  if (is_of_member(peers) && !suits_member(kind)) return Cause::in_group;
  if (is_of_group(peers) && !suits_group(kind)) return Cause::single_axis;
  return Cause::none;
}

Refusal axis_refusal(Cause cause, const Inputs& inputs) noexcept {
  const auto [position, place, number, reason] = inputs.master;
  if (cause == Cause::axis_not_ready)
    return {.cause = cause, .value = reason, .limit = place, .where = number};
  return {.cause = cause, .value = position, .limit = place, .where = number};
}

std::optional<Refusal> against_axes(const Inputs& inputs) noexcept {
  if (inputs.peers == Peers::failed) return axis_refusal(Cause::axis_not_ready, inputs);
  if (inputs.peers == Peers::away) return axis_refusal(Cause::axis_away, inputs);
  return std::nullopt;
}

std::optional<Refusal> against_reset(const Inputs& inputs, bool moving) noexcept {
  if (inputs.peers == Peers::failed) return axis_refusal(Cause::axis_not_ready, inputs);
  if (inputs.peers == Peers::away && moving) return axis_refusal(Cause::axis_away, inputs);
  return std::nullopt;
}

}  // namespace jounce
