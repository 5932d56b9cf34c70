// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace jounce::edit_detail {

/// Throws InputError, with the message of the other verbs, if the file is not a spec. Accepts a spec
/// with errors, an empty file, and a file that does not exist.
void require_spec(const std::string& path);

/// Returns example specs as JSON: [{"kind", "text", "picture"}]. The picture is an SVG document; ""
/// for a kind without a motion.
std::string gallery(const std::map<std::string, std::string>& templates);

}  // namespace jounce::edit_detail
