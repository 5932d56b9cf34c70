// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/gear/follow.hpp"

/// The passes that the cam of a follow spec contains; for the cam and its check.
namespace jounce::gear_detail {

struct FollowPass {
  std::size_t table = 0;
  double master = 0;  ///< origin of the pass
  double slave = 0;
  double entry = 0;    ///< ratio at the start of the pass, if its first segment is `continued`
  bool again = false;  ///< true: a further pass of the same table
  std::vector<PtRate> ratios;
};

/// All passes, validated. An endless table has one, or two if the second pass differs.
std::vector<FollowPass> follow_passes(const FollowSpec& spec);

/// True if the cam repeats: it has a single table, which is endless, and whose passes are all the
/// same.
bool repeats(const FollowSpec& spec, const std::vector<FollowPass>& passes);

/// A position for messages, with 12 significant digits.
std::string place(double x);

}  // namespace jounce::gear_detail
