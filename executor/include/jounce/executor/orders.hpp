// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/command.hpp"
#include "jounce/axis/machine.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

/// Command of the axis for an order of the wire: the same with named values. Nothing if it needs a
/// movement (gears) or is about a queue.
std::optional<Command> command_of(const OrderRequested& order);

/// The movement of a gear order, for an axis at rest at `position`. Throws InputError for a spec out
/// of range; nothing for other orders.
std::unique_ptr<Movement> gear_of(const OrderRequested& order, std::uint64_t id,
                                  const AxisConfig& config, double position);

}  // namespace jounce
