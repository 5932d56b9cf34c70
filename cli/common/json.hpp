// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace jounce::cli {

/// An object that keeps the order of its keys.
using Json = nlohmann::ordered_json;

/// Results of a verb for each axis, by its name.
using AxisDocuments = std::vector<std::pair<std::string, Json>>;

/// One axis: its document as it is. Several: {"ok": ..., "axes": {"x": ..., "y": ...}}, where `ok`,
/// if they have one, is true if all are.
Json document_of(AxisDocuments axes);

}  // namespace jounce::cli
