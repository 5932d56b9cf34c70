// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/spec/spec.hpp"

namespace jounce::edit_detail {

/// Returns the knots and segments of a cam as a JSON object, "null" for a spec of another kind.
/// docs/reference/http.md describes the members.
std::string cam_json(const Spec& spec);

}  // namespace jounce::edit_detail
