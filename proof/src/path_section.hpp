// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"
#include "jounce/plot/page.hpp"

namespace jounce {

/// Returns a section about the path to which an axis belongs: times, costs, and the places that
/// cost most.
Section path_section(const Input& input);

}  // namespace jounce
