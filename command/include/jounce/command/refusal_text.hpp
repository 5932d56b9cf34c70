// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/command/cause.hpp"

namespace jounce {

/// Refusal::text() with the unit of the positions of the axis at its numbers; "": no unit.
/// "velocity_limit: The motion exceeds the velocity limit of the axis: 678.45 mm/s at 0.61 s, limit 500 mm/s."
std::string text(const Refusal& refusal, const std::string& unit);

}  // namespace jounce
