// SPDX-License-Identifier: Apache-2.0
// Rows into a queue of the executor: one long table, or two banks.
#include <utility>

#include <fmt/format.h>

#include "jounce/base/detail/progress_line.hpp"
#include "jounce/design/detail/executor_tables.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "cli/common/input.hpp"
#include "cli/machine/outcome.hpp"
#include "cli/machine/streaming.hpp"

namespace jounce::cli {
namespace {

/// The given options that apply to whole tables only, and --rolling if it is one of them; "": none.
std::string of_tables(const StreamArguments& options, bool rolling) {
  return given_options({{"--rolling", rolling},
                        {"--swap", !options.swaps.empty()},
                        {"--live", options.live},
                        {"--master", !options.master.empty()},
                        {"--until", options.until != "start"}});
}

RowPlan row_plan_of(const StreamArguments& options) {
  ExecutorTables tables =
      executor_tables(load_program_axis(options.file, options.machine, options.axis));
  if (tables.slave.table.axis() != Domain::time)
    throw InputError("--rolling", options.file, "must be a table over time");
  RowPlan plan = row_plan(options.to, std::move(tables.slave), options.capacity, options.relative);
  plan.resume = options.resume;
  return plan;
}

BankPlan bank_plan_of(const StreamArguments& options) {
  const TableFile first = bank_of(load_program_axis(options.file, options.machine, options.axis));
  const TableFile second = bank_of(load(options.bank, options.axis));
  if (const std::string rule = queue_conflict(first, second, options.file); !rule.empty())
    throw InputError("--bank", options.bank, rule);
  return bank_plan(first, second, options.loops, options.relative);
}

}  // namespace

int stream_rolling(const StreamArguments& options) {
  if (const std::string others = of_tables(options, false); !others.empty())
    throw InputError("--rolling", "", "sends one table over time: omit " + others);
  RowPlan plan = row_plan_of(options);
  KeyedLink link = open_link(options.link);
  RowOptions rolling;
  rolling.key = link.key();
  WatchedWork work("streaming to " + options.to);
  rolling.cancelled = [&] { return work.interrupted(); };
  rolling.progress = [&](const RowProgress& p) {
    work.goes_on(p.sent == 0 ? 0 : static_cast<double>(p.played) / static_cast<double>(p.sent),
                 fmt::format("{} rows played, {} ahead", p.played, p.acknowledged - p.played));
  };
  const RowOutcome outcome = stream_rows(link.transport(), std::move(plan), rolling);
  return report_outcome(outcome, options.to, options.json ? rows_json(outcome) : "",
                        rows_text(outcome, options.to),
                        {StreamError::refused, StreamError::underrun}, link);
}

int play(const BankPlan& plan, const StreamArguments& options, BankOptions::Until until,
         const std::string& what, const std::string& end) {
  KeyedLink link = open_link(options.link);
  Client client(link.transport(), options.to, {.key = link.key()});
  WatchedWork work("streaming to " + options.to);
  const CallOutcome outcome = play_banks(
      client, plan,
      {.until = until,
       .progress = [&](const wire::QueueAck& level) { work.goes_on(0, name(level.progress)); },
       .cancelled = [&] { return work.interrupted(); }});
  static_cast<void>(client.release());
  const std::string ran = work.interrupted() ? "stopped" : end;
  return report_outcome(
      outcome, options.to, options.json ? outcome_json(outcome) : "",
      with_remark(fmt::format("{} at {}: {}", what, options.to, ran), plan.remark),
      {StreamError::refused}, link);
}

int stream_banks(const StreamArguments& options) {
  if (const std::string others = of_tables(options, options.rolling); !others.empty())
    throw InputError("--bank", options.bank, "fills two banks of rows: omit " + others);
  return play(bank_plan_of(options), options, BankOptions::Until::finished,
              options.file + " and " + options.bank, "finished");
}

}  // namespace jounce::cli
