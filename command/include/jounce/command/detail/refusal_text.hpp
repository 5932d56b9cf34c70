// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "jounce/command/cause.hpp"

namespace jounce {

/// Returns Refusal::text() with units: "velocity_limit: The motion exceeds the velocity limit of
/// the axis: 678.45 mm/s at 0.61 s, limit 500 mm/s." `unit`: unit of the axis's position; "": no
/// unit. `master_unit`: unit of the position of its master. `axes`: names of the axes of the group
/// that rejected.
std::string text(const Refusal& refusal, const std::string& unit,
                 const std::string& master_unit = "", std::span<const std::string> axes = {});

/// Returns a position as text, with up to twelve digits: for a position that an axis must reach
/// within a tolerance.
std::string place_text(double place);

/// Returns the value that exceeds its limit in a text of text(): 678.45. nullopt: the text contains
/// no such value.
std::optional<double> refused_value(const std::string& text);

/// Returns the axis of a group that a rejection axis_not_ready names, with its state: "x is
/// disabled."; "" without such an axis. `axes`: names of the axes of the group.
std::string unready_axis_text(const Refusal& refusal, std::span<const std::string> axes);

}  // namespace jounce
