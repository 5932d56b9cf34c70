// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/stream_plan.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "jounce/profiles/error.hpp"

#include "stream/src/message/refusal.hpp"

namespace jounce {
namespace {

TableInUnits in_units(const StreamPlan::Item& item) {
  return {item.table, item.units};
}

/// `master` may be beyond the last table: there is none then.
void require_fit(const StreamPlan& plan, const SwapPlan& leg) {
  require_valid(leg.coupling);
  if (leg.mode == wire::ArmMode::queue)
    throw InputError("mode", name(leg.mode),
                     "must play tables: use stream_rows() or StaticQueue for a queue");
  std::optional<TableInUnits> master;
  if (leg.master < plan.tables.size()) master.emplace(in_units(plan.tables[leg.master]));
  const Refused refused =
      misfit(leg.mode, in_units(plan.tables[leg.slave]), master ? &*master : nullptr);
  if (refused) throw InputError("table", "", refused.reason);
}

void require_armable(const StreamPlan& plan) {
  if (plan.goal == StreamGoal::download) return;
  for (const SwapPlan& leg : legs_of(plan)) {
    if (leg.slave >= plan.tables.size())
      throw InputError("swap", std::to_string(leg.slave + 1), "is not the number of a table");
    require_fit(plan, leg);
    if (!std::isfinite(leg.position))
      throw InputError("swap position", std::to_string(leg.position), "must be finite");
  }
}

}  // namespace

void require_valid(const StreamPlan& plan) {
  if (plan.tables.empty() || plan.tables.size() > wire::most_tables)
    throw InputError("tables", std::to_string(plan.tables.size()), "must be 1 to 64");
  if (plan.start_tick < -1)
    throw InputError("start_tick", std::to_string(plan.start_tick), "must be -1 or more");
  require_armable(plan);
}

std::vector<SwapPlan> legs_of(const StreamPlan& plan) {
  std::vector<SwapPlan> legs{{.slave = 0,
                              .master = 1,
                              .mode = plan.mode,
                              .coupling = plan.coupling,
                              .when = plan.when,
                              .position = plan.position,
                              .end = plan.end}};
  legs.insert(legs.end(), plan.swaps.begin(), plan.swaps.end());
  return legs;
}

wire::Header header_of(const StreamPlan::Item& item, std::size_t index, std::size_t values) {
  const Table& table = item.table;
  if (table.size() > std::numeric_limits<std::int32_t>::max())
    throw InputError("knots", std::to_string(table.size()), "must fit 31 bits");
  const auto knots = static_cast<std::uint32_t>(table.size());
  const wire::Cut cut = wire::cut(table.rule(), knots, values);
  return {.table = static_cast<std::uint32_t>(index),
          .hash = item.hash.value_or(Sha256{}),
          .axis = table.axis(),
          .rule = table.rule(),
          .outside = table.outside(),
          .units = item.units,
          .knots = knots,
          .columns = cut.columns,
          .per_chunk = cut.per_chunk,
          .chunks = cut.chunks};
}

wire::Chunk chunk_of(const Table& table, const wire::Header& header, std::uint32_t seq) {
  const wire::Cut cut = wire::cut(header);
  wire::Chunk chunk{.table = header.table,
                    .seq = seq,
                    .first_knot = seq * cut.per_chunk,
                    .knots = cut.knots_of(seq, header.knots),
                    .columns = cut.columns};
  const auto& [x, p, v, a] = table.columns();
  chunk.values.reserve(std::size_t{chunk.knots} * chunk.columns);
  for (const auto* column : {&x, &p, &v, &a}) {
    if (!column->empty()) {
      chunk.values.insert(chunk.values.end(), column->begin() + chunk.first_knot,
                          column->begin() + chunk.first_knot + chunk.knots);
    }
  }
  return chunk;
}

}  // namespace jounce
