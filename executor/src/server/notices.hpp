// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jounce/axis/tick.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/executor/executor_options.hpp"

namespace jounce {

/// Returns the names of the axes of a group; none for a single axis.
std::span<const std::string> group_names(const ExecutorOptions& options);

/// Returns the present fault of an axis as a sentence, with its numbers and limits: "following_error:
/// The following error exceeded its limit ..." `unit`: unit of its positions. `axes`: names of the
/// axes, if it is a group.
std::string fault_text(const Tick& now, const std::string& unit, const AxisConfig& config = {},
                       std::span<const std::string> axes = {});

/// Returns text() of a rejection, with the state of the axis in this tick: the present fault for
/// in_error and not_enabled, the reason for no_master_input, the present motion for start_position,
/// the possible distances for a relative move. `order`: kind of the rejected command. `live`: the
/// armed motion follows a live master.
std::string refusal_text(const Refusal& refusal, const Tick& now, const ExecutorOptions& options,
                         CommandKind order = CommandKind::none, bool live = false);

/// Returns the changes of an axis between two of its ticks as sentences: "started at tick 1600". For
/// the other parameters, see fault_text().
std::vector<std::string> notices_of(const Tick& before, const Tick& now, const std::string& unit,
                                    const AxisConfig& config = {},
                                    std::span<const std::string> axes = {});

}  // namespace jounce
