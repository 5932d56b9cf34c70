// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Returns the result of a drive as lines of `jounce validate`, and as JSON. `u`: unit of the
/// position.
std::string drive_text(const DriveResult& result, const DriveSpec& spec, const std::string& u);
nlohmann::ordered_json drive_json(const DriveResult& result, const DriveSpec& spec);

}  // namespace jounce
