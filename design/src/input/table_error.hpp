// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// True if the number of knots is given, so that the table has the least error for this number.
bool is_best_of_so_many(const Input& input);

/// The finding for the error of the table against its tolerance. Requires input.error.
Finding table_error(const Input& input);

}  // namespace jounce::design_detail
