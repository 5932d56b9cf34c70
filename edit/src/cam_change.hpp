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
/// cam. Knots are counted from 0, the start of the cam; segment i ends at knot i, so segments are
/// counted from 1, as in the messages of Jounce. `path`: name of the file. Throws InputError if the
/// text is not a cam, for a change that is not in the list, and for one that the cam cannot have.
ChangedText changed_cam(const std::string& path, const std::string& text,
                        const std::string& change);

}  // namespace jounce::edit_detail
