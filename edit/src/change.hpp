// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::edit_detail {

/// The changed text, and a name for the change.
struct ChangedText {
  std::string text;
  std::string label;
};

/// Applies a change, given as a JSON object (docs/reference/http.md lists them), to the text of a
/// spec. `path`: name of the file. Throws InputError if the text is not a spec, for a change that is
/// not in the list, and for one that the spec cannot have.
ChangedText changed(const std::string& path, const std::string& text, const std::string& change);

}  // namespace jounce::edit_detail
