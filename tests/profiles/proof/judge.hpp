// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "profiles/proof/reachable.hpp"
#include "profiles/proof/workloads.hpp"

namespace jounce::proof {

/// The move and its verdict; counts one case. A refusal is a failure, as every draw is solvable.
struct Solved {
  MoveResult move;
  Verdict verdict;
  explicit operator bool() const { return move && verdict.ok(); }
};
Solved solve(const Case& c, Tally& tally);

/// A share of a checked move's scale, forgiven; at `rounding` not less than the checker's floor, as
/// the witness cannot ask for what phases of doubles do not resolve. The durations and the least
/// duration under it.
Slack slack_of(const Verdict& move, Real share);
std::vector<Span> reachable(const Case& c, const Verdict& move, Real share);
Real minimum(const std::vector<Span>& spans);

/// Permitted rounding of the witness itself.
constexpr Real last_bit = 0x1p-60L;

/// The least duration if the data may be off by a share of their scale.
using Reference = std::function<Real(Real share)>;

/// The question as text, for people.
using Asked = std::function<std::string()>;

/// Compares a duration with a reference: equal, a tie, or a failure.
void compare(Real is, const Reference& reference, const Asked& asked, Tally& tally);
void compare(Real is, const Reference& reference, const Case& c, Tally& tally);

/// A case of any draw but those for themselves.
Case any(Random& r);
/// A case whose limits lie far apart from each other, or of a start that runs out of them.
Case far_apart(Random& r);

/// 17 digits.
std::string text(Real x);

// The experiments; each draws a case of its own.
void optimality(Random& r, Tally& tally);
void optimality_unequal(Random& r, Tally& tally);
void blocks(Random& r, Tally& tally);
void blocks_unequal(Random& r, Tally& tally);
void exact(Random& r, Tally& tally);
void exact_unequal(Random& r, Tally& tally);
void velocity(Random& r, Tally& tally);
void stops(Random& r, Tally& tally);
void overshoot(Random& r, Tally& tally);
void invariance(Random& r, Tally& tally);
void replan_rest(Random& r, Tally& tally);
void replan_unequal(Random& r, Tally& tally);
void replan_moving(Random& r, Tally& tally);
void walls(Random& r, Tally& tally);
void relations(Random& r, Tally& tally);
void driven_one(Random& r, Tally& tally);
void driven_together(Random& r, Tally& tally);
void certified(Random& r, Tally& tally);
void certified_velocity(Random& r, Tally& tally);
void sync_time(Random& r, Tally& tally);
void sync_phase(Random& r, Tally& tally);

}  // namespace jounce::proof
