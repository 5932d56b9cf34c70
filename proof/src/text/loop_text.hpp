// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "jounce/validate/loop.hpp"

namespace jounce {

/// The result of loop_stability(); nullopt if it throws, as for a delay of too many cycles.
std::optional<LoopStability> loop_of(const Drive& drive);

/// "gain margin 8.2 dB at 98 Hz"; with "downwards" if a stable loop becomes unstable when its gain falls by the margin;
/// "" without a margin.
std::string gain_text(const LoopStability& loop);
/// "phase margin 43.1 deg at 35 Hz".
std::string phase_text(const LoopStability& loop);

/// "stable", "unstable at 98.7 Hz".
std::string stability_text(const LoopStability& loop);

/// "unstable at 98.7 Hz, gain margin ..., phase margin ...", or "stable, gain margin ...".
std::string loop_text(const LoopStability& loop);

nlohmann::ordered_json loop_json(const LoopStability& loop);

}  // namespace jounce
