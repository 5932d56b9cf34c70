// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jounce/gear/follow.hpp"
#include "jounce/pvt/segment_row.hpp"

namespace jounce {

/// Follow tables as rows for the two FIFOs (banks) of an axis. The axis plays the first bank once,
/// then the second one `loops` times.
///
///     const FollowBanks banks = follow_banks(spec, 1U << 20U);
///     // fill bank 0 with banks.first, bank 1 with banks.second; queue the switch; start
///
/// The first bank contains all tables except the last, with all their passes. If the first pass of
/// the last table differs from its later passes (because of FollowSpec::start_ratio), the first
/// bank contains this pass, too. If the first bank would be empty, it contains the last table and
/// is played `loops` times; `second` is then empty.
struct FollowBanks {
  std::vector<SegmentRow> first = {};   ///< rows of the first bank
  std::vector<SegmentRow> second = {};  ///< rows of the second bank
  std::int64_t loops = 1;               ///< below 1: endless
};

/// Throws InputError like follow(), and "loops" if a bank would have more than `most` rows.
FollowBanks follow_banks(const FollowSpec& spec, std::size_t most);

}  // namespace jounce
