// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "study/src/optimum/shape_words.hpp"

/// The result of an optimization of free shapes, as text and as JSON.
namespace jounce::study_detail {

std::string text_of(const CamShapeOutcome& outcome, const ShapeWords& words);

nlohmann::ordered_json json_of(const CamShapeOutcome& outcome, const ShapeWords& words);

}  // namespace jounce::study_detail
