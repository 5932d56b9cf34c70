// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/path/plan.hpp"

namespace jounce {

/// For each piece of plan.path(), the piece of plan.drawn() of which it is a part. They are the
/// same unless joints are fitted.
std::vector<std::size_t> drawn_pieces(const Plan& plan);

}  // namespace jounce
