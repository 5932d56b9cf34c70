// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/design/input.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// The input's table through the [drive] of its spec, which must exist. Findings name their part
/// ("drive"), in seconds and with their units. Throws InputError if a cam has no [master].
DriveResult driven(const Input& input, std::size_t samples = 0);

}  // namespace jounce
