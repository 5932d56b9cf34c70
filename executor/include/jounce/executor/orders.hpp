// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/command.hpp"
#include "jounce/axis/machine.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

/// Returns the axis command for an order of the wire, with named values; nullopt if it needs a
/// movement (gears) or concerns a queue.
std::optional<Command> command_of(const OrderRequested& order);

/// Returns the movement of a gear order, for an axis at rest at `position`; null for other orders.
/// Throws InputError for a spec out of range.
std::unique_ptr<Movement> gear_of(const OrderRequested& order, std::uint64_t id,
                                  const AxisConfig& config, double position);

}  // namespace jounce
