// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce {

/// Returns an input as a version for compare(), with the segments of its spec as knots. `path`
/// names it, because two versions of a cam often have the same name.
Version version_of(const Input& input, const std::string& path);

/// Pairs the axes of two files: the only axis of each, or axes of the same name. Throws InputError
/// (key "axis") if an axis has no partner; `before_path` and `after_path` name the files in
/// messages.
std::vector<std::pair<Input, Input>> paired_axes(std::vector<Input> before,
                                                 std::vector<Input> after,
                                                 const std::string& before_path,
                                                 const std::string& after_path);

}  // namespace jounce
