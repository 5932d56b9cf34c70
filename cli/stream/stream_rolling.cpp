// SPDX-License-Identifier: Apache-2.0
#include "cli/stream/stream_rolling.hpp"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/design/executor_tables.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/row_sender.hpp"

#include "cli/common/input.hpp"
#include "cli/common/interrupt.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

RowPlan row_plan_of(const RollingOptions& options) {
  Input input = load(options.file, options.axis);
  ExecutorTables tables = executor_tables(input);
  if (tables.slave.table.axis() != Domain::time)
    throw InputError("--rolling", options.file, "must be a table over time");
  const Travel travel = travel_of(tables.slave.table);
  return {.executor = options.to,
          .queue = {.units = tables.slave.units,
                    .capacity = options.ahead,
                    .prefill = options.ahead,
                    .relative = options.relative,
                    .origin = options.relative ? 0 : tables.slave.table.columns().p[0],
                    .lowest = travel.lowest,
                    .highest = travel.highest},
          .rows = source_of(std::move(tables.slave.table)),
          .resume = options.resume};
}

int report(const RowOutcome& outcome, const RollingOptions& options) {
  const RowProgress& p = outcome.progress;
  if (options.json) {
    const nlohmann::ordered_json document{
        {"ok", outcome.ok()}, {"error", name(outcome.error)}, {"reason", outcome.reason},
        {"rows", p.sent},     {"played", p.played},           {"underruns", p.underruns},
        {"resent", p.resent}, {"finished", p.finished}};
    fmt::print("{}\n", document.dump(1));
  } else if (outcome.ok()) {
    fmt::print("{} of {} rows played at {}, {} underruns, {} messages sent again; {}\n", p.played,
               p.sent, options.to, p.underruns, p.resent, p.finished ? "finished" : "stopped");
  } else {
    fmt::print(stderr, "jounce: {}\n", said_of(outcome.error, outcome.reason));
  }
  if (outcome.ok()) return fine;
  const bool said_no =
      outcome.error == StreamError::refused || outcome.error == StreamError::underrun;
  return said_no ? finding : fault;
}

}  // namespace

int stream_rolling(const RollingOptions& options) {
  RowPlan plan = row_plan_of(options);
  Link link(options.link);
  RowOptions rolling;
  rolling.key = link.key();
  const Interrupt interrupt;
  rolling.cancelled = [&] { return interrupt.asked(); };
  Progress progress("streaming to " + options.to);
  rolling.progress = [&](const RowProgress& p) {
    progress.show(p.sent == 0 ? 0 : static_cast<double>(p.played) / static_cast<double>(p.sent),
                  fmt::format("{} rows played, {} ahead", p.played, p.acknowledged - p.played));
  };
  return report(stream_rows(link.transport(), std::move(plan), rolling), options);
}

}  // namespace jounce::cli
