// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce::test {

/// Conditions on every result of a generator, for all numbers; every generator's test calls this.
///
/// - the joints are continuous up to the derivative `order` (to rounding of the curve's magnitude);
/// - the derivative of the integral is the curve, and the derivative curve agrees with the jet;
/// - no point of a dense sample lies outside the extrema that were called exact;
/// - reversed twice it is itself.
template <class Over>
void expect_invariants(const Curve<Over>& f, int order) {
  const Ranges ranges = extrema(f);
  std::array<double, 4> scale{};
  for (std::size_t k = 0; k < 4; ++k) scale[k] = std::abs(ranges[k].peak().value);

  EXPECT_TRUE(check_continuity(f, order).ok());

  const Curve<Over> slope = derivative(f);
  const Curve<Over> back = derivative(integral(f, 1));
  const Curve<Over> twice = reversed(reversed(f));
  for (std::size_t i = 0; i < f.segments().size(); ++i)
    for (int n = 0; n <= 64; ++n) {
      const double s = static_cast<double>(n) / 64;
      const Jet jet = evaluate(f.segments()[i], s);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_GE(jet[k], ranges[k].min.value - 1e-12 * scale[k]) << "derivative " << k;
        EXPECT_LE(jet[k], ranges[k].max.value + 1e-12 * scale[k]) << "derivative " << k;
      }
      EXPECT_NEAR(value(slope.segments()[i], s), jet[1], 1e-12 * scale[1]);
      EXPECT_NEAR(value(back.segments()[i], s), jet[0], 1e-12 * magnitude(f.segments()[i]));
      EXPECT_NEAR(value(twice.segments()[i], s), jet[0], 1e-12 * magnitude(f.segments()[i]));
    }
}

}  // namespace jounce::test
