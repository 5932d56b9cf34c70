// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::edit_detail {

/// Each function reads the text of a spec with the file name `path`, and throws InputError for a
/// text without a motion, and for one with several axes.

/// Returns the table in the form with this name (form_names()).
std::string exported_table(const std::string& path, const std::string& text,
                           const std::string& form);
/// Returns the page of `jounce report`.
std::string exported_report(const std::string& path, const std::string& text);

/// Returns the differences of two texts as the members of a JSON object, without its braces:
/// "difference", the output of `jounce diff`, and "charts", each with both curves. If one of the
/// texts describes no motion, "difference" is its error.
std::string difference_members(const std::string& path, const std::string& before,
                               const std::string& after);

}  // namespace jounce::edit_detail
