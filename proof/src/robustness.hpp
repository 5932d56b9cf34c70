// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "jounce/proof/proof.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// Computes the drive over its tolerances, on all cores. Only the calling thread calls `progress`.
ToleranceResult robustness(const SignalView& reference, const DriveSpec& drive,
                           const ProofProgress& progress);

/// Returns the worst case of every figure as lines of `jounce validate`, and as JSON. `unit`: unit
/// of the position.
std::string robustness_text(const ToleranceResult& result, const std::string& unit);
nlohmann::ordered_json robustness_json(const ToleranceResult& result);

}  // namespace jounce
