// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/gear/follow.hpp"

/// The passes that a follow spec's cam shows, for the cam and for its check.
namespace jounce::gear_detail {

struct FollowPass {
  std::size_t table = 0;
  double master = 0;  ///< origin
  double slave = 0;
  double entry = 0;    ///< ratio with which a continued first segment begins
  bool again = false;  ///< not the first pass of its table
  std::vector<PtRate> ratios;
};

/// All passes, validated. An endless table has one, or two where the second differs.
std::vector<FollowPass> follow_passes(const FollowSpec& spec);

/// True if the cam repeats: it has one endless table, which is the same in each pass.
bool repeats(const FollowSpec& spec, const std::vector<FollowPass>& passes);

/// For people: six digits, or all that count of a position.
std::string rounded(double x, int digits = 6);
inline std::string place(double x) {
  return rounded(x, 12);
}

}  // namespace jounce::gear_detail
