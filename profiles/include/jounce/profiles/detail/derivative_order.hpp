// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/error.hpp"

namespace jounce::profiles_detail {

/// Throws InputError unless the order of a derivative is from 0 (the value) to 3.
inline void require_order(int order) {
  if (order < 0 || order > 3) throw InputError("order", order, "must be from 0 to 3");
}

}  // namespace jounce::profiles_detail
