#include "stream_banks.hpp"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/row_sender.hpp"
#include "jounce/stream/static_queue.hpp"

#include "interrupt.hpp"
#include "progress.hpp"
#include "reference.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

/// A table over a master as it is, one over time in seconds.
TableFile bank_of(const std::string& file, const std::string& axis) {
  const Input input = load(file, axis);
  if (input.table.table.axis() == Axis::master) return input.table;
  return executor_tables(input).slave;
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
                     "must be over the same, in the same units, as " + options.first);
  const std::size_t most = std::max(first.table.size(), second.table.size());
  return {.queue = {.axis = first.table.axis(),
                    .units = first.units,
                    .mode = wire::QueueMode::static_,
                    .capacity = static_cast<std::uint32_t>(std::max<std::size_t>(most, 2)),
                    .loops = options.loops},
          .first = rows_of(first.table)(first.table.size()),
          .second = rows_of(second.table)(second.table.size())};
}

/// Nothing starts after a Ctrl-C.
CallOutcome play(StaticQueue& queue, const Banks& banks, const Interrupt& interrupt) {
  CallOutcome outcome = queue.open();
  const auto goes_on = [&] { return outcome.ok() && !interrupt.asked(); };
  if (goes_on()) outcome = queue.fill(0, banks.first);
  if (goes_on()) outcome = queue.fill(1, banks.second);
  if (goes_on()) outcome = queue.arm();
  if (goes_on()) outcome = queue.start();
  if (goes_on()) outcome = queue.switch_over();
  return outcome;
}

/// Looks on, ten times a second, until it is over: played to its end, stopped, or out of contact.
CallOutcome watch(Client& client, StaticQueue& queue, Progress& progress,
                  const Interrupt& interrupt) {
  for (;;) {
    if (interrupt.asked()) return client.stop();
    const auto level = queue.level();
    if (!level) return {StreamError::contact_lost, {}, 0, "the executor answers no more"};
    progress.show(0, name(level->progress));
    if (level->refusal != wire::Refusal::none)
      return {StreamError::refused, level->refusal, 0, level->reason};
    if (level->progress == wire::Progress::done) return {};
    if (level->progress == wire::Progress::broken)
      return {StreamError::stopped, {}, 0, "the axis was stopped"};
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

int report(const CallOutcome& outcome, const BankOptions& options, bool interrupted) {
  if (options.json) {
    const nlohmann::ordered_json document{
        {"ok", outcome.ok()}, {"error", name(outcome.error)}, {"reason", outcome.reason}};
    fmt::print("{}\n", document.dump(1));
  } else if (outcome.ok()) {
    fmt::print("{} and {} at {}: {}\n", options.first, options.second, options.to,
               interrupted ? "stopped" : "finished");
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
  if (outcome.ok()) outcome = watch(client, queue, progress, interrupt);
  static_cast<void>(client.release());
  return report(outcome, options, interrupt.asked());
}

}  // namespace jounce::cli
