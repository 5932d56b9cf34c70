// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "profiles/proof/certificate.hpp"

namespace jounce::proof {

/// A functional with fewer instants and a greater margin: those without pressure are left out, and
/// the rest (weights, instants, pressures) are moved as long as that helps, one at a time and then
/// together (Hooke and Jeeves 1961). `bound` judges every trial, so nothing can go wrong here.
Functional polished(Functional f, const Question& q);

}  // namespace jounce::proof
