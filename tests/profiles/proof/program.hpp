// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "profiles/proof/certificate.hpp"

namespace jounce::proof {

/// Proposes a functional for `bound`: the dual of a linear program (Clp). Its variables are a jerk
/// that is constant between the instants `grid` (ascending, the last is T), and the states there,
/// within their envelopes; it minimises the distance to the target. The answer need not be right: a
/// bad proposal only certifies nothing.
Functional proposed(const Question& q, const std::vector<Real>& grid);

}  // namespace jounce::proof
