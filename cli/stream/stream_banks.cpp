// SPDX-License-Identifier: Apache-2.0
#include "cli/stream/stream_banks.hpp"

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/design/executor_tables.hpp"
#include "jounce/gear/follow_banks.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/receiver/static_queue.hpp"
#include "jounce/stream/sender/row_sender.hpp"

#include "cli/common/interrupt.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

/// A table over a master as it is, one over time in seconds.
TableFile bank_of(const std::string& file, const std::string& axis) {
  const Input input = load(file, axis);
  if (input.table.table.axis() == Domain::master) return input.table;
  return executor_tables(input).slave;
}

/// Travel of the first table, then of the second one `loops` times. Each pass begins at the end of the previous one.
Travel travel_of(const Table& first, const Table& second, std::int32_t loops) {
  Travel all = jounce::travel_of(first);
  const Travel each = jounce::travel_of(second);
  const double last = all.net + (loops - 1) * each.net;  // start of the last pass
  all.lowest = std::min(all.lowest, std::min(all.net, last) + each.lowest);
  all.highest = std::max(all.highest, std::max(all.net, last) + each.highest);
  all.net = last + each.net;
  return all;
}

struct Banks {
  wire::Queue queue;
  std::vector<wire::Row> first, second;
};

Banks banks_of(const BankOptions& options) {
  const TableFile first = bank_of(options.first, options.axis);
  const TableFile second = bank_of(options.second, options.axis);
  if (first.table.axis() != second.table.axis() || first.units.x != second.units.x ||
      first.units.position != second.units.position)
    throw InputError("--bank", options.second,
                     "must be over the same variable (time or master) and in the same units as " +
                         options.first);
  const std::size_t most = std::max(first.table.size(), second.table.size());
  const Travel travel = travel_of(first.table, second.table, options.loops);
  return {.queue = {.axis = first.table.axis(),
                    .units = first.units,
                    .mode = wire::QueueMode::static_,
                    .capacity = static_cast<std::uint32_t>(std::max<std::size_t>(most, 2)),
                    .loops = options.loops,
                    .relative = options.relative,
                    .origin = options.relative ? 0 : first.table.columns().p[0],
                    .lowest = travel.lowest,
                    .highest = travel.highest},
          .first = source_of(first.table)(first.table.size()),
          .second = source_of(second.table)(second.table.size())};
}

std::vector<wire::Row> on_wire(const std::vector<SegmentRow>& rows) {
  std::vector<wire::Row> sent;
  sent.reserve(rows.size());
  for (const SegmentRow& row : rows) sent.push_back(jounce::on_wire(row));
  return sent;
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

Banks banks_of(const Input& input, const FollowOptions& options) {
  const FollowPart& part = std::get<FollowPart>(std::get<SyncSpec>(input.spec->subject));
  const FollowBanks tables = tables_of(part, input);
  const std::size_t most = std::max(tables.first.size(), tables.second.size());
  Banks banks{.queue = {.axis = Domain::master,
                        .units = input.table.units,
                        .mode = wire::QueueMode::static_,
                        .capacity = static_cast<std::uint32_t>(std::max<std::size_t>(most, 2)),
                        .loops = static_cast<std::int32_t>(tables.loops),
                        .relative = options.relative},
              .first = on_wire(tables.first),
              .second = on_wire(tables.second)};
  if (part.start.event == FollowEvent::pass) {
    banks.queue.event = wire::QueueEvent::pass;
    banks.queue.event_position = part.start.position;
    banks.queue.event_direction = static_cast<std::int8_t>(part.start.direction);
  }
  return banks;
}

/// Nothing starts after a Ctrl-C. The switch is queued before the start: however short the first bank
/// is, the second one follows it.
CallOutcome play(StaticQueue& queue, const Banks& banks, const Interrupt& interrupt) {
  CallOutcome outcome = queue.open();
  const auto goes_on = [&] { return outcome.ok() && !interrupt.asked(); };
  if (goes_on()) outcome = queue.fill(0, banks.first);
  if (goes_on() && !banks.second.empty()) outcome = queue.fill(1, banks.second);
  if (goes_on()) outcome = queue.arm();
  if (goes_on() && !banks.second.empty()) outcome = queue.switch_over();
  if (goes_on()) outcome = queue.start();
  return outcome;
}

/// The end that the queue reports; nothing while it plays or waits.
std::optional<CallOutcome> ended(const wire::QueueAck& level) {
  if (level.refusal != wire::Refusal::none)
    return CallOutcome{StreamError::refused, level.refusal, 0, level.reason};
  if (level.progress == wire::Progress::done) return CallOutcome{};
  if (level.progress == wire::Progress::broken)
    return CallOutcome{StreamError::stopped, {}, 0, "the axis was stopped"};
  return std::nullopt;
}

/// Polls ten times a second until the end: played, stopped, out of contact, or `enough` returns true.
template <class Enough>
CallOutcome watch(Client& client, StaticQueue& queue, Progress& progress,
                  const Interrupt& interrupt, Enough enough) {
  for (;;) {
    if (interrupt.asked()) return client.stop();
    const auto level = queue.level();
    if (!level) return {StreamError::contact_lost, {}, 0, "the executor does not answer any more"};
    progress.show(0, name(level->progress));
    if (const auto end = ended(*level)) return *end;
    if (enough(*level)) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

int report(const CallOutcome& outcome, const std::string& done, bool json) {
  if (json) {
    const nlohmann::ordered_json document{
        {"ok", outcome.ok()}, {"error", name(outcome.error)}, {"reason", outcome.reason}};
    fmt::print("{}\n", document.dump(1));
  } else if (outcome.ok()) {
    fmt::print("{}\n", done);
  } else {
    fmt::print(stderr, "jounce: {}\n", said_of(outcome.error, outcome.reason));
  }
  if (outcome.ok()) return fine;
  return outcome.error == StreamError::refused ? finding : fault;
}

}  // namespace

int stream_banks(const BankOptions& options) {
  const Banks banks = banks_of(options);
  Link link(options.link);
  Client client(link.transport(), options.to, {.key = link.key()});
  StaticQueue queue(client, banks.queue);
  const Interrupt interrupt;
  Progress progress("streaming to " + options.to);
  CallOutcome outcome = play(queue, banks, interrupt);
  if (outcome.ok())
    outcome =
        watch(client, queue, progress, interrupt, [](const auto& /*level*/) { return false; });
  static_cast<void>(client.release());
  return report(outcome,
                fmt::format("{} and {} at {}: {}", options.first, options.second, options.to,
                            interrupt.asked() ? "stopped" : "finished"),
                options.json);
}

int stream_follow(const Input& input, const FollowOptions& options) {
  const Banks banks = banks_of(input, options);
  Link link(options.link);
  Client client(link.transport(), options.to, {.key = link.key()});
  StaticQueue queue(client, banks.queue);
  const Interrupt interrupt;
  Progress progress("streaming to " + options.to);
  CallOutcome outcome = play(queue, banks, interrupt);
  const auto follows = [&](const wire::QueueAck& level) {
    return !options.wait || level.progress != wire::Progress::waiting;
  };
  if (outcome.ok()) outcome = watch(client, queue, progress, interrupt, follows);
  static_cast<void>(client.release());
  const bool waits = banks.queue.event == wire::QueueEvent::pass && !options.wait;
  return report(outcome,
                fmt::format("{} at {}: {}", input.name, options.to,
                            interrupt.asked() ? "stopped"
                            : waits           ? "waits for its master"
                                              : "started"),
                options.json);
}

}  // namespace jounce::cli
