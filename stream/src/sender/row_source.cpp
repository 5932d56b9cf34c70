// SPDX-License-Identifier: Apache-2.0
// The rows of a table, for a RowSender or a StaticQueue.
#include <algorithm>
#include <utility>

#include "jounce/pvt/segment_row.hpp"
#include "jounce/stream/detail/row_sender.hpp"

namespace jounce {
namespace {

wire::RowOrder order_of(Interpolation rule) {
  return rule == Interpolation::linear          ? wire::RowOrder::linear
         : rule == Interpolation::cubic_hermite ? wire::RowOrder::cubic
                                                : wire::RowOrder::quintic;
}

/// The row that ends at knot `i`, from 1.
wire::Row row_to(const Table& table, std::size_t i) {
  const auto& [x, p, v, a] = table.columns();
  wire::Row row{.x_end = x[i] - x[0],
                .p_end = p[i] - p[0],
                .order = order_of(table.rule()),
                .last = i + 1 == table.size()};
  if (!v.empty()) row.v_start = v[i - 1], row.v_end = v[i];
  if (!a.empty()) row.a_start = a[i - 1], row.a_end = a[i];
  return row;
}

}  // namespace

wire::Row on_wire(const SegmentRow& row) {
  wire::Row sent{.x_end = row.x_end,
                 .p_end = row.p_end,
                 .order = static_cast<wire::RowOrder>(row.degree),
                 .last = row.last};
  if (row.degree >= 2) sent.v_start = row.v_start, sent.v_end = row.v_end;
  if (row.degree == 5) sent.a_start = row.a_start, sent.a_end = row.a_end;
  return sent;
}

SegmentRow segment_row(const wire::Row& row) {
  return {.x_end = row.x_end,
          .p_end = row.p_end,
          .v_start = row.v_start,
          .v_end = row.v_end,
          .a_start = row.a_start,
          .a_end = row.a_end,
          .degree = static_cast<int>(row.order),
          .last = row.last};
}

Travel travel_of(const Table& table) {
  Travel travel;
  RowStart from;
  for (std::size_t i = 1; i < table.size(); ++i) {
    const SegmentRow row = segment_row(row_to(table, i));
    const RowPeaks peaks = jounce::peaks(row, from, 0);
    travel.lowest = std::min(travel.lowest, peaks.position_min);
    travel.highest = std::max(travel.highest, peaks.position_max);
    from = {row.x_end, row.p_end};
  }
  travel.net = from.position;
  return travel;
}

RowSource source_of(Table table) {
  return [table = std::move(table), next = std::size_t{1}](std::size_t most) mutable {
    std::vector<wire::Row> rows;
    for (; next < table.size() && rows.size() < most; ++next) rows.push_back(row_to(table, next));
    return rows;
  };
}

}  // namespace jounce
