// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/program.hpp"

namespace jounce::path_detail {

inline constexpr double unlimited = PathSettings::none;  ///< a velocity, acceleration or jerk

}  // namespace jounce::path_detail
