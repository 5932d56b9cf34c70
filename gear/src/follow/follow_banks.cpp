// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/detail/follow_banks.hpp"

#include <algorithm>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// Appends one pass of the table, from the end of the present rows.
void add_pass(const FollowTable& table, std::vector<SegmentRow>& rows) {
  const RowStart from = rows.empty() ? RowStart{} : RowStart{rows.back().x_end, rows.back().p_end};
  bool first = true;
  for (const PtPoint& point : table.segments) {
    SegmentRow row = row_of(point, first);
    first = false;
    row.x_end += from.x;
    row.p_end += from.position;
    rows.push_back(row);
  }
}

void require_room(const FollowTable& table, std::int64_t passes, std::size_t taken,
                  std::size_t most) {
  const std::size_t each = table.segments.size();
  if (each <= most && static_cast<std::size_t>(passes) <= (most - std::min(taken, most)) / each)
    return;
  throw InputError("loops", std::to_string(table.loops),
                   "makes more than the " + std::to_string(most) + " rows that a bank holds");
}

/// True if the first pass of the last table begins like all later ones.
bool begins_alike(const FollowSpec& spec) {
  return spec.start_ratio == 0 || spec.tables.size() > 1 ||
         spec.tables.front().segments.front().type != PtType::continued;
}

}  // namespace

FollowBanks follow_banks(const FollowSpec& spec, std::size_t most) {
  static_cast<void>(follow(spec));  // throws for an invalid follow spec
  FollowBanks banks;
  for (std::size_t i = 0; i + 1 < spec.tables.size(); ++i) {
    const FollowTable& table = spec.tables[i];
    require_room(table, table.loops, banks.first.size(), most);
    for (std::int64_t pass = 0; pass < table.loops; ++pass) add_pass(table, banks.first);
  }
  const FollowTable& last = spec.tables.back();
  require_room(last, 1, 0, most);
  banks.loops = last.loops;
  const bool once_before = !begins_alike(spec);
  if (once_before || banks.first.empty()) add_pass(last, banks.first);
  if (!once_before && spec.tables.size() == 1) return banks;
  if (spec.tables.front().segments.front().type == PtType::continued)
    banks.first.front().v_start = spec.start_ratio;
  if (once_before && last.loops == 1) return banks;
  if (once_before && last.loops > 1) banks.loops = last.loops - 1;
  add_pass(last, banks.second);
  return banks;
}

}  // namespace jounce
