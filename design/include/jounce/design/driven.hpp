// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/design/input.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Simulates the input's table with the [drive] of its spec. Requires a spec with [drive]. In each
/// finding, `axis` is "drive", `where` is a time in s, and `unit` and `where_unit` are set.
/// `samples` is the number of points of the result; 0: none. Throws InputError if a cam has no
/// [master].
DriveResult driven(const Input& input, std::size_t samples = 0);

}  // namespace jounce
