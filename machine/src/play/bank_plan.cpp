// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/design/detail/executor_tables.hpp"
#include "jounce/gear/detail/follow_banks.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/sync_spec.hpp"

namespace jounce {
namespace {

/// Travel of the first table, then of the second one `loops` times. Each pass begins at the end of
/// the previous one.
Travel whole_travel(const Table& first, const Table& second, std::int32_t loops) {
  Travel all = jounce::travel_of(first);
  const Travel each = jounce::travel_of(second);
  const double last = all.net + (loops - 1) * each.net;  // start of the last pass
  all.lowest = std::min(all.lowest, std::min(all.net, last) + each.lowest);
  all.highest = std::max(all.highest, std::max(all.net, last) + each.highest);
  all.net = last + each.net;
  return all;
}

/// Rows of the larger bank; a bank has two rows at least.
std::uint32_t capacity_for(std::size_t first, std::size_t second) {
  return static_cast<std::uint32_t>(std::max({first, second, std::size_t{2}}));
}

/// "over time [s], with positions in mm".
std::string variable_and_units(const TableFile& file) {
  const bool over_time = file.table.axis() == Domain::time;
  return std::string("over ") + (over_time ? "time" : "a master") +
         (file.units.x.empty() ? "" : " in " + file.units.x) + ", with positions " +
         (file.units.position.empty() ? "without a unit" : "in " + file.units.position);
}

const FollowPart* follow_part(const Input& input) {
  const auto* const sync = input.spec ? std::get_if<SyncSpec>(&input.spec->subject) : nullptr;
  return sync != nullptr ? std::get_if<FollowPart>(sync) : nullptr;
}

std::vector<wire::Row> on_wire(const std::vector<SegmentRow>& rows) {
  std::vector<wire::Row> sent;
  sent.reserve(rows.size());
  for (const SegmentRow& row : rows) sent.push_back(jounce::on_wire(row));
  return sent;
}

/// The ratio at the beginning of a pass: the first one that is not 0. `from`: start of each bank.
double ratio_at_pass(const FollowBanks& banks, RowStart from) {
  constexpr double rounding = 1e-9;
  std::vector<const std::vector<SegmentRow>*> passes{&banks.first};
  if (!banks.second.empty()) passes.push_back(&banks.second);
  if (banks.loops != 1) passes.push_back(passes.back());
  double end = 0;
  for (const auto* const rows : passes) {
    const double ratio = rates(rows->front(), from, end).start;
    if (std::abs(ratio) > rounding) return ratio;
    RowStart at = from;
    for (const SegmentRow& row : *rows) {
      end = rates(row, at, end).end;
      at = {row.x_end, row.p_end};
    }
  }
  return 0;
}

/// A master that turns back beyond the beginning of a pass stops the slave at once.
std::string pass_remark(const FollowPart& part, const FollowBanks& banks, RowStart from,
                        const Units& units) {
  const double ratio = part.direction == 0 ? ratio_at_pass(banks, from) : 0;
  if (ratio == 0) return "";
  const bool alike = units.position == units.x;
  return "the ratio at the beginning of a pass is " + six_digits(ratio) +
         (alike ? "" : " " + units.position + "/" + units.x) +
         ": if the master moves back beyond this place, the axis stops with the fault jump";
}

/// The tables of a follow spec; of a plan the table that `design` makes of it.
FollowBanks tables_of(const FollowPart& part, const Input& input) {
  constexpr std::size_t most = std::size_t{1} << 20U;  // an executor's bank
  if (const auto* const spec = std::get_if<FollowSpec>(&part.slave))
    return follow_banks(*spec, most);
  const bool periodic = std::get<FollowPlan>(part.slave).periodic;
  FollowBanks banks{.first = rows_of(input.table.table), .loops = periodic ? 0 : 1};
  for (SegmentRow& row : banks.first) row.last = false;
  return banks;
}

RowStart start_of_banks(const FollowPart& part, const Input& input) {
  const bool is_plan = std::holds_alternative<FollowPlan>(part.slave);
  return is_plan ? start_of(input.table.table) : RowStart{};
}

/// Throws InputError for a table at whose end the axis would still move: it reports an underrun there.
void require_rest_at_end(const TableFile& table) {
  constexpr double rounding = 1e-9;  // the number of SegmentFifos
  const Columns& c = table.table.columns();
  const std::size_t n = c.x.size();
  const double slope = (c.p[n - 1] - c.p[n - 2]) / (c.x[n - 1] - c.x[n - 2]);
  const double end = c.v.empty() ? slope : c.v[n - 1];
  const double before = c.v.empty() ? slope : c.v[n - 2];
  if (std::abs(end) <= rounding * std::abs(before - end)) return;
  const std::string& unit = table.units.position;
  throw InputError(
      "velocity", number(end) + (unit.empty() ? "" : " " + unit + "/s"),
      "at the end of the table is not 0, but an axis plays rows to rest: add a ramp to "
      "rest at the end");
}

}  // namespace

bool is_follow(const Input& input) {
  return follow_part(input) != nullptr;
}

std::optional<double> pass_position(const Input& input) {
  const FollowPart* const part = follow_part(input);
  if (part == nullptr || part->start.event != FollowEvent::pass) return std::nullopt;
  return part->start.position;
}

BankPlan follow_bank_plan(const Input& input, bool relative) {
  const FollowPart& part = *follow_part(input);
  const FollowBanks tables = tables_of(part, input);
  BankPlan banks{.queue = {.axis = Domain::master,
                           .units = input.table.units,
                           .mode = wire::QueueMode::static_,
                           .capacity = capacity_for(tables.first.size(), tables.second.size()),
                           .loops = static_cast<std::int32_t>(tables.loops),
                           .relative = relative},
                 .first = on_wire(tables.first),
                 .second = on_wire(tables.second)};
  banks.remark = pass_remark(part, tables, start_of_banks(part, input), input.table.units);
  banks.queue.direction = static_cast<std::int8_t>(part.direction);
  if (part.start.event == FollowEvent::pass) {
    banks.queue.event = wire::QueueEvent::pass;
    banks.queue.event_position = part.start.position;
    banks.queue.event_direction = static_cast<std::int8_t>(part.start.direction);
  }
  return banks;
}

TableFile bank_of(const Input& input) {
  if (input.table.table.axis() == Domain::master) return input.table;
  return executor_tables(input).slave;
}

std::string queue_conflict(const TableFile& first, const TableFile& second,
                           const std::string& file) {
  const std::string ours = variable_and_units(first);
  const std::string other = variable_and_units(second);
  if (ours == other) return "";
  return "is " + other + ", but " + file + " is " + ours +
         ": give two tables over the same variable, in the same units";
}

BankPlan bank_plan(const TableFile& first, const TableFile& second, std::int32_t loops,
                   bool relative) {
  const Travel travel = whole_travel(first.table, second.table, loops);
  return {.queue = {.axis = first.table.axis(),
                    .units = first.units,
                    .mode = wire::QueueMode::static_,
                    .capacity = capacity_for(first.table.size(), second.table.size()),
                    .loops = loops,
                    .relative = relative,
                    .origin = relative ? 0 : first.table.columns().p[0],
                    .lowest = travel.lowest,
                    .highest = travel.highest},
          .first = source_of(first.table)(first.table.size()),
          .second = source_of(second.table)(second.table.size())};
}

RowPlan row_plan(const std::string& executor, TableFile table, std::uint32_t ahead, bool relative) {
  require_rest_at_end(table);
  const Travel travel = travel_of(table.table);
  return {.executor = executor,
          .queue = {.units = table.units,
                    .capacity = ahead,
                    .prefill = ahead,
                    .relative = relative,
                    .origin = relative ? 0 : table.table.columns().p[0],
                    .lowest = travel.lowest,
                    .highest = travel.highest},
          .rows = source_of(std::move(table.table))};
}

std::string given_options(const std::vector<std::pair<std::string, bool>>& options) {
  std::string all;
  for (const auto& [name, given] : options)
    if (given) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace jounce
