// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/inputs.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"

namespace jounce {

/// The rules that an axis has as a group of the machine, or as an axis of a group (AxisGroup in
/// machine.hpp). The machine states in Inputs::peers which of them applies: a group reads whether its
/// axes can follow it, an axis whether its group is enabled or moves. For an axis alone, no function
/// returns a reason.

/// Returns the reason to reject a command of this kind, or none: an axis of an enabled group accepts
/// no motion, and a group accepts only the commands of a path.
Cause against_role(Peers peers, CommandKind kind) noexcept;

/// Returns the refusal with the axis that Inputs::master names (Peers::away, Peers::failed): the number
/// of the axis, and its place or the bits of all axes that are not ready.
Refusal axis_refusal(Cause cause, const Inputs& inputs) noexcept;

/// Returns the reason why a group at rest cannot begin or continue its path, or nullopt.
std::optional<Refusal> against_axes(const Inputs& inputs) noexcept;

/// Returns the reason why a group stays in its fault, or nullopt. `moving`: it keeps its path, so that
/// it can continue.
std::optional<Refusal> against_reset(const Inputs& inputs, bool moving) noexcept;

}  // namespace jounce
