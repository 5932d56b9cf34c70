#pragma once

#include <cstdio>

#include <nlohmann/json.hpp>

#include "shape_words.hpp"

/// What became of free shapes, for people and for machines.
namespace jounce::cli {

void print_text(std::FILE* out, const CamShapeOutcome& outcome, const ShapeWords& words);

nlohmann::ordered_json json_of(const CamShapeOutcome& outcome, const ShapeWords& words);

}  // namespace jounce::cli
