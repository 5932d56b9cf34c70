// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "jounce/validate/follower.hpp"

namespace jounce {

/// Returns the result of a cam follower as lines of `jounce validate`, and as JSON. `unit`: unit of
/// the lift.
std::string follower_text(const FollowerResult& run, const std::string& unit);
nlohmann::ordered_json follower_json(const FollowerResult& run);

}  // namespace jounce
