// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "profiles/proof/checker.hpp"
#include "support/random.hpp"

namespace jounce::proof {

using test::Random;

/// A kind of random problem for one axis. Every target drawn can be reached; starts may lie outside
/// the bounds.
struct Draw {
  const char* name;
  const char* what;  ///< for people
  Case (*draw)(Random&);
  bool alone = false;  ///< no part of `any`
};

/// Ruckig's own distributions first, then those on which it was measured to fail.
std::span<const Draw> draws();

/// By name; the names are those of draws().
Case draw(const char* name, Random& random);

/// Normal with mean 0 (Box-Muller), and the same or 0.
double normal(Random& random, double deviation);
double normal_or_zero(Random& random, double probability, double deviation);

}  // namespace jounce::proof
