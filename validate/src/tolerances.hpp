// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jounce::validate_detail {

/// The least tolerance of an integration that a caller may choose, relative.
inline constexpr double finest_integration = 1e-12;

}  // namespace jounce::validate_detail
