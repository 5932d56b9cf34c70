// SPDX-License-Identifier: Apache-2.0
#include "stream/src/message/refusal.hpp"

#include <utility>

namespace jounce {
namespace {

Refused not_over_time(const char* which, TableInUnits table) {
  if (table.table.axis() != Domain::time)
    return {wire::Refusal::wrong_axis, std::string(which) + " table must be over time"};
  if (table.units.x != "s") {
    return {wire::Refusal::wrong_unit,
            std::string(which) + " table is over " + table.units.x + ", must be over s"};
  }
  return {};
}

/// True for a list of numbers: a linear table over their index.
std::string unit_name(const std::string& unit) {
  return unit.empty() ? "no unit" : unit;
}

bool is_list(const Table& table) {
  const std::vector<double>& x = table.columns().x;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i] != static_cast<double>(i)) return false;
  return table.rule() == Interpolation::linear;
}

}  // namespace

Refused contradiction(const wire::Header& header) {
  const auto bad = [](std::string reason) {
    return Refused{wire::Refusal::bad_header, std::move(reason)};
  };
  if (header.table >= wire::most_tables) return bad("a session has at most 64 tables");
  if (header.knots < 2) return bad("a table needs at least 2 knots");
  const std::uint32_t columns = wire::cut(header.rule, header.knots).columns;
  if (header.columns != columns) {
    return bad(std::string("a ") + name(header.rule) + " table has " + std::to_string(columns) +
               " columns, not " + std::to_string(header.columns));
  }
  if (header.per_chunk < 1 || header.per_chunk > wire::chunk_values / columns) {
    return bad("a chunk has 1 to " + std::to_string(wire::chunk_values / columns) + " knots, not " +
               std::to_string(header.per_chunk));
  }
  if (const std::uint32_t chunks = wire::cut(header).chunks; header.chunks != chunks) {
    return bad(std::to_string(header.knots) + " knots make " + std::to_string(chunks) +
               " chunks, not " + std::to_string(header.chunks));
  }
  return {};
}

Refused misfit(wire::ArmMode mode, TableInUnits slave, const TableInUnits* master) {
  if (mode == wire::ArmMode::play) return not_over_time("the slave", slave);
  if (mode == wire::ArmMode::path && !is_list(slave.table))
    return {wire::Refusal::wrong_axis,
            "the program of a path must be a linear table over 0, 1, 2, ..."};
  if (slave.table.axis() != Domain::master)
    return {wire::Refusal::wrong_axis,
            "the table of the axis is over time, but it must be over the position of a master"};
  if (mode == wire::ArmMode::follow_input || mode == wire::ArmMode::path) return {};
  if (master == nullptr)
    return {wire::Refusal::table_missing, "the table of the master is missing"};
  if (Refused refused = not_over_time("the master", *master)) return refused;
  if (master->units.position != slave.units.x) {
    return {wire::Refusal::wrong_unit, "the master moves in " + unit_name(master->units.position) +
                                           ", the slave table is over " + unit_name(slave.units.x)};
  }
  return {};
}

}  // namespace jounce
