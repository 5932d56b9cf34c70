// SPDX-License-Identifier: Apache-2.0
#include "cli/stream/stream_options.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <optional>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/design/executor_tables.hpp"
#include "jounce/design/sync_check.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/sync_spec.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

/// Ctrl-C stops what was armed before the streamer leaves.
volatile std::sig_atomic_t interrupted = 0;

/// From the first knot on, wherever the master and, of an axis that turns on, the slave are by then.
void begin_at_cut(const Table& table, CouplingSpec& coupling) {
  coupling.master_absolute = false;
  coupling.master_offset = table.start();
  const double stroke = table.columns().p.back() - table.columns().p.front();
  const bool turns = table.outside() == Extrapolation::advance && stroke != 0;
  if (turns && !coupling.slave_period) coupling.slave_period = std::abs(stroke);
}

/// Adds what this plays to the tables of the plan.
SwapPlan add_input(StreamPlan& plan, Input input, const StreamVerb& options) {
  const auto coupling = input.spec ? input.spec->coupling : std::nullopt;
  ExecutorTables tables = [&] {
    if (options.live) return ExecutorTables{input.table, std::nullopt};
    if (options.master.empty()) return executor_tables(input);
    return ExecutorTables{input.table, read_table(options.master)};
  }();
  SwapPlan added{.slave = plan.tables.size(), .master = plan.tables.size() + 1};
  plan.tables.push_back({std::move(tables.slave.table), tables.slave.units});
  if (tables.master) {
    plan.tables.push_back({std::move(tables.master->table), tables.master->units});
    added.mode = wire::ArmMode::follow_table;
    added.coupling = coupling.value_or(CouplingSpec{});
  }
  if (options.live) {
    added.mode = wire::ArmMode::follow_input;
    added.coupling = coupling.value_or(CouplingSpec{});
    added.end = options.keep_velocity                      ? CamEnd::keep_velocity
                : input.spec && stays_in_gear(*input.spec) ? CamEnd::extend
                                                           : CamEnd::brake;
    if (options.at_next_cut) begin_at_cut(plan.tables.back().table, added.coupling);
  }
  return added;
}

/// --start-at, in the unit of the master.
double start_of(const StreamVerb& options, const std::string& unit) {
  try {
    return quantity(options.start_at, unit);
  } catch (const InputError& error) {
    throw InputError("--start-at", options.start_at, error.rule());
  }
}

}  // namespace

StreamPlan plan_of(const StreamVerb& options, const std::string& executor, Input input) {
  if (options.live && !options.master.empty())
    throw InputError("--master", options.master,
                     "cannot be combined with --live: the axis has its own master");
  StreamPlan plan;
  plan.executor = executor;
  const SwapPlan first = add_input(plan, std::move(input), options);
  plan.mode = first.mode;
  plan.coupling = first.coupling;
  plan.end = first.end;
  plan.await = !options.no_wait;
  if (options.at_next_cut) plan.when = StartAt::end_of_table;
  if (!options.start_at.empty()) {
    plan.when = StartAt::master_position;
    plan.position = start_of(options, plan.tables.front().units.x);
  }
  for (const std::string& file : options.swaps)
    plan.swaps.push_back(add_input(plan, load(file, options.axis), options));
  plan.goal = options.until == "download" ? StreamGoal::download
              : options.until == "arm"    ? StreamGoal::arm
                                          : StreamGoal::start;
  return plan;
}

StreamOptions stream_options(const StreamVerb& options, const Link& link) {
  StreamOptions stream;
  stream.key = link.key();
  stream.total = nanos(options.patience);
  // Before the total time is over: "no answer" explains more than "time is up".
  stream.sender.patience = std::min(stream.sender.patience, stream.total * 3 / 4);
  interrupted = 0;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  stream.cancelled = [] { return interrupted != 0; };
  return stream;
}

std::int64_t tick_of(const StreamVerb& options, Link& link, const std::string& executor) {
  if (options.at.empty()) return -1;
  const bool from_now = options.at.front() == '+';
  const auto number = number_in(from_now ? options.at.substr(1) : options.at);
  const bool good =
      number && *number >= 0 && *number <= 1e15 && (from_now || *number == std::floor(*number));
  if (!good)
    throw InputError("--at", options.at, "must be a tick, or + and seconds from now: 120000, +2.5");
  if (!from_now) return static_cast<std::int64_t>(*number);
  link.transport().subscribe(wire::channel(executor, wire::Lane::status), 1);
  const auto message =
      next_status(link.transport(), executor, std::chrono::seconds(2), steady_now, link.key());
  if (!message)
    throw TransportError("no status of executor " + executor + " arrived: " + unheard_hint);
  const auto& status = std::get<wire::Status>(message->body);
  return status.tick + static_cast<std::int64_t>(std::llround(*number * 1e9)) / status.cycle_ns;
}

bool is_live_follow(const Input& input, const StreamVerb& options) {
  const auto* const sync = input.spec ? std::get_if<SyncSpec>(&input.spec->subject) : nullptr;
  const auto* const part = sync != nullptr ? std::get_if<FollowPart>(sync) : nullptr;
  if (part != nullptr && !options.live && part->start.event == FollowEvent::pass)
    throw InputError("follow.pass", number(part->start.position),
                     "is a position of a live master: stream it with --live");
  return part != nullptr && options.live;
}

}  // namespace jounce::cli
