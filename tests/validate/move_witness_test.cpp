// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "jounce/profiles/moves/move.hpp"
#include "jounce/validate/witness.hpp"

#include "support/random.hpp"

namespace jounce::move_witness_test {
namespace {

// The long-double checker of tests/profiles/proof sees every random move; a sample of them is
// integrated here by an ODE solver, which does not use phases and their formulas.

MotionState random_state(test::Random& random) {
  return {random.uniform(-4, 4), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(MoveWitness, IntegratesASampleOfRandomMovesToTheirTargets) {
  test::Random random(77);
  int integrated = 0;
  for (int i = 0; i < 300; ++i) {
    const MotionState from = random_state(random);
    const MotionState to = random_state(random);
    const Bounds b{-random.uniform(2, 8), random.uniform(2, 8),   -random.uniform(1, 8),
                   random.uniform(1, 8),  -random.uniform(1, 20), random.uniform(1, 20)};
    const Durations possible = durations(from, to, b);
    if (possible.status != MoveStatus::ok) continue;
    const double stretched = possible.at_least(possible.minimum * random.uniform(1, 3));
    for (const MoveResult& move : {move_to(from, to, b), move_to(from, to, b, stretched)}) {
      ASSERT_TRUE(move) << i << explain(move.status);
      const Witness w = witness(with(move.profile.curve(), Extrapolation::refuse));
      EXPECT_TRUE(w.report.ok()) << i;
      EXPECT_LE(w.position.relative, 1e-9) << i;
      EXPECT_LE(w.velocity.relative, 1e-9) << i;
    }
    ++integrated;
    if (HasFailure()) break;
  }
  EXPECT_GT(integrated, 250);  // the targets of the others cannot be reached inside the bounds
}

}  // namespace
}  // namespace jounce::move_witness_test
