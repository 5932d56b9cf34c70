// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/command.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/commands.hpp"

namespace jounce {

/// Returns a client's command in the form in which the axis executes it. Returns nullopt for a
/// command that needs a movement (gears), or concerns a queue or the table of the axis.
std::optional<AxisCommand> axis_command_of(const ClientCommand& command);

/// Returns the movement of a gear command, for an axis at rest at `position`, u (unit of the axis);
/// null for other commands. `id`: id of the movement. Throws InputError for a value out of range.
std::unique_ptr<Movement> gear_of(const ClientCommand& command, std::uint64_t id,
                                  const AxisConfig& config, double position);

}  // namespace jounce
