// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/optimize/shape_words.hpp"

/// Result of free shapes, as text and as JSON.
namespace jounce::cli {

void print_text(std::FILE* out, const CamShapeOutcome& outcome, const ShapeWords& words);

nlohmann::ordered_json json_of(const CamShapeOutcome& outcome, const ShapeWords& words);

}  // namespace jounce::cli
