// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jounce::profiles_detail {

/// Returns 1, 0 or -1.
inline double sign(double x) {
  return static_cast<double>((x > 0) - (x < 0));
}

}  // namespace jounce::profiles_detail
