// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce {

/// An input as a version for compare(), with the segments of its spec as knots; `path` names it, as two versions of one
/// cam have one name.
Version version_of(const Input& input, const std::string& path);

}  // namespace jounce
