// The rows of a table, for a RowSender or a StaticQueue.
#include <utility>

#include "jounce/stream/row_sender.hpp"

namespace jounce {
namespace {

wire::RowOrder order_of(Rule rule) {
  return rule == Rule::linear          ? wire::RowOrder::linear
         : rule == Rule::cubic_hermite ? wire::RowOrder::cubic
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

RowSource rows_of(Table table) {
  return [table = std::move(table), next = std::size_t{1}](std::size_t most) mutable {
    std::vector<wire::Row> rows;
    for (; next < table.size() && rows.size() < most; ++next) rows.push_back(row_to(table, next));
    return rows;
  };
}

}  // namespace jounce
