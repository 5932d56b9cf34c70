// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce {

/// Returns an input as a version for compare(). Its knots are the segments of the spec. `path` is
/// the name of the version, because two versions of a cam often have the same name.
Version version_of(const Input& input, const std::string& path);

/// Throws InputError if one motion is over the master and the other over time. The paths are the
/// names of the two in the message.
void require_one_kind(const Input& before, const Input& after, const std::string& before_path,
                      const std::string& after_path);

/// Pairs the axes of two files: axes of the same name or, if each file has only one axis, these
/// two. If `axis` is given, returns only the axis of this name; if only one of the files has
/// several axes, the axis of this name is paired with the single axis of the other file. Throws
/// InputError (key "axis") if an axis has no partner. `before_path` and `after_path` are the names
/// of the files in messages.
std::vector<std::pair<Input, Input>> paired_axes(std::vector<Input> before,
                                                 std::vector<Input> after,
                                                 const std::string& before_path,
                                                 const std::string& after_path,
                                                 const std::string& axis = "");

}  // namespace jounce
