#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace jounce::cli {

/// What a verb says of each axis, under its name. One axis: as it is. Several: {"ok": ..., "axes":
/// {"x": ..., "y": ...}}, ok (where they have one) if all are.
void print_json(std::vector<std::pair<std::string, nlohmann::ordered_json>>& axes);

}  // namespace jounce::cli
