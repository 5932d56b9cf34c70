// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/pvt/sample.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::design_detail {

/// Returns the table of a curve, and its error. Without a tolerance, the error is at most a
/// billionth of the stroke. Throws InputError with the keys of [table].
template <class Over>
Sampled table_of(const Curve<Over>& curve, const TableOptions& options, const Limits& limits);

}  // namespace jounce::design_detail
