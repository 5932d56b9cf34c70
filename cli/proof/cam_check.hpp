// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "cli/common/input.hpp"

namespace jounce::cli {

/// Adds the findings of a cam besides its limits: warnings, certificates, and whether the
/// master of the spec keeps [limits.slave]. Steps up to the derivative `continuity` are left out: a
/// check of their own finds them. Adds nothing to a motion over time.
void add_cam_findings(Report& report, const Input& input, int continuity);

/// All that `jounce check` finds.
Report checked(const Input& input, int continuity = 1, const EngageState& at = {});

/// A line a rise with its characteristic values, and the fastest master; "" for a motion over time.
std::string cam_text(const Input& input);

/// The same in full; null for a motion over time.
nlohmann::ordered_json cam_json(const Input& input);

}  // namespace jounce::cli
