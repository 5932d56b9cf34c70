// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Result of a drive, as the lines of `validate` and as its JSON; u: the unit of the position.
std::string drive_text(const DriveResult& result, const DriveSpec& spec, const std::string& u);
nlohmann::ordered_json drive_json(const DriveResult& result, const DriveSpec& spec);

}  // namespace jounce
