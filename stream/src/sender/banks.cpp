// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/banks.hpp"

#include <chrono>
#include <optional>
#include <thread>

namespace jounce {
namespace {

/// Starts nothing after a cancellation. The switch is queued before the start: however short the
/// first bank is, the second one follows it.
CallOutcome start(StaticQueue& queue, const BankPlan& plan,
                  const std::function<bool()>& cancelled) {
  CallOutcome outcome = queue.open();
  const auto goes_on = [&] { return outcome.ok() && !(cancelled && cancelled()); };
  if (goes_on()) outcome = queue.fill(0, plan.first);
  if (goes_on() && !plan.second.empty()) outcome = queue.fill(1, plan.second);
  if (goes_on()) outcome = queue.arm();
  if (goes_on() && !plan.second.empty()) outcome = queue.switch_over();
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

bool is_reached(BankOptions::Until goal, const wire::QueueAck& level) {
  if (goal == BankOptions::Until::started) return level.progress != wire::Progress::waiting;
  return goal == BankOptions::Until::accepted;
}

}  // namespace

CallOutcome play_banks(Client& client, const BankPlan& plan, const BankOptions& options) {
  StaticQueue queue(client, plan.queue);
  if (CallOutcome outcome = start(queue, plan, options.cancelled); !outcome.ok()) return outcome;
  for (;;) {
    if (options.cancelled && options.cancelled()) return client.stop();
    const auto level = queue.level();
    if (!level) return {StreamError::contact_lost, {}, 0, "the executor has stopped answering"};
    if (options.progress) options.progress(*level);
    if (const auto end = ended(*level)) return *end;
    if (is_reached(options.until, *level)) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

}  // namespace jounce
