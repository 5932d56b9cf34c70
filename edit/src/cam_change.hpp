// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/src/change.hpp"
#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {

/// Applies a change of a cam to its text. Knots are counted from 0, the start of the cam; segment i
/// ends at knot i, so segments are counted from 1, as in the messages of Jounce. Returns nullopt for a
/// change that is not one of cams. Throws InputError if the text is not a cam, and for a change that
/// the cam cannot have.
std::optional<ChangedText> changed_cam(const std::string& path, const std::string& text,
                                       const JsonReader& change);

/// Returns the names of these changes.
std::vector<std::string> cam_changes();

}  // namespace jounce::edit_detail
