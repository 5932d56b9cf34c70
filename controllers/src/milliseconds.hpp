// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jounce::controllers_detail {

inline constexpr double ms = 1e-3;  ///< s

}  // namespace jounce::controllers_detail
