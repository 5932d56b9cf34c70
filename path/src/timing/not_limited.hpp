// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/program.hpp"

namespace jounce::path_detail {

inline constexpr double none = PathSettings::none;  ///< not limited

}  // namespace jounce::path_detail
