// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "jounce/validate/loop.hpp"

namespace jounce {

/// Returns the result of loop_stability(); nullopt if it throws, such as for a delay of too many
/// cycles.
std::optional<LoopStability> loop_of(const Drive& drive);

/// Returns "gain margin 8.2 dB at 98 Hz". The text contains "downwards" if a stable loop becomes
/// unstable when its gain falls by the margin. "" if there is no margin.
std::string gain_text(const LoopStability& loop);
/// Returns "phase margin 43.1 deg at 35 Hz".
std::string phase_text(const LoopStability& loop);

/// Returns "stable", or "unstable at 98.7 Hz".
std::string stability_text(const LoopStability& loop);

/// Returns all of these: "stable, gain margin ...", or "unstable at 98.7 Hz, gain margin ..., phase
/// margin ...".
std::string loop_text(const LoopStability& loop);

/// Returns the same as JSON.
nlohmann::ordered_json loop_json(const LoopStability& loop);

}  // namespace jounce
