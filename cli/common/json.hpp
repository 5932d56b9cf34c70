// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace jounce::cli {

/// An object that keeps the order of its keys.
using Json = nlohmann::ordered_json;

/// Prints a document with an indent of one space.
void print_json(std::FILE* out, const Json& document);
inline void print_json(const Json& document) {
  print_json(stdout, document);
}

/// Results of a verb for each axis, by its name.
using AxisDocuments = std::vector<std::pair<std::string, Json>>;

/// The document of one axis unchanged. Of several axes {"ok": ..., "axes": {"x": ..., "y": ...}};
/// `ok` is true if it is true for all axes, and is left out if they have none.
Json document_of(AxisDocuments axes);

}  // namespace jounce::cli
