// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jounce/gear/follow.hpp"
#include "jounce/pvt/segment_row.hpp"

namespace jounce {

/// Follow tables as the two FIFOs of an axis play them: the first bank once, then the second `loops` times.
///
///     const FollowBanks banks = follow_banks(spec, 1U << 20U);
///     ... fill bank 0 with banks.first, bank 1 with banks.second; queue the switch; start
///
/// The first bank holds all tables but the last, their passes one after another, and of the last one the
/// pass that differs from the later ones (FollowSpec::start_ratio). Where nothing precedes the last
/// table, `second` is empty and the first bank itself is played `loops` times.
struct FollowBanks {
  std::vector<SegmentRow> first = {};
  std::vector<SegmentRow> second = {};
  std::int64_t loops = 1;  ///< below 1: endless
};

/// Throws InputError like follow(), and "loops" if a bank would have more than `most` rows.
FollowBanks follow_banks(const FollowSpec& spec, std::size_t most);

}  // namespace jounce
