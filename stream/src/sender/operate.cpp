// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/operate.hpp"

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>
#include <variant>

#include "jounce/command/cause.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/stream/transport/link.hpp"

#include "stream/src/sender/reasons.hpp"

namespace jounce {

using namespace std::chrono_literals;

namespace {

CallOutcome not_homed(std::int32_t cause) {
  const auto why = static_cast<Cause>(cause);
  return {StreamError::refused, wire::Refusal::axis, cause,
          std::string("not homed: ") + name(why) + ": " + meaning(why)};
}

CallOutcome home_outcome(const wire::Status& status) {
  if (status.homed) return {};
  if (status.last_error != 0) return not_homed(status.last_error);
  return not_homed(status.reason);
}

bool is_at_rest(State state) {
  return state == State::standstill || state == State::disabled || state == State::error_stop;
}

/// In a fault, an axis may still brake.
bool is_at_rest(const wire::Status& status) {
  return is_at_rest(status.state) && status.slave_velocity == 0;
}

std::optional<wire::Status> next_status_of(Transport& link, const std::string& executor,
                                           Nanos timeout, const std::optional<wire::Key>& key,
                                           const Clock& clock) {
  auto message = next_status(link, executor, timeout, key, clock);
  if (!message) return std::nullopt;
  return std::get<wire::Status>(std::move(message->body));
}

}  // namespace

std::optional<wire::Status> present_status(Transport& link, const std::string& executor,
                                           Nanos timeout, const std::optional<wire::Key>& key,
                                           const Clock& clock) {
  return next_status_of(link, executor, timeout, key, clock);
}

std::optional<wire::GroupStatus> present_group(Transport& link, const std::string& executor,
                                               Nanos timeout, const std::optional<wire::Key>& key,
                                               const Clock& clock) {
  link.subscribe(wire::channel(executor, wire::Lane::group), 1);
  Rejects rejects;
  drain(link, Nanos{}, key, rejects, [](const wire::Message& /*old*/) {});
  const Nanos end = clock() + timeout;
  for (Nanos left = timeout; left > Nanos{}; left = end - clock()) {
    const auto message = next_message(link, left, rejects, key);
    const auto* const group = message && message->executor == executor
                                  ? std::get_if<wire::GroupStatus>(&message->body)
                                  : nullptr;
    if (group != nullptr) return *group;
  }
  return std::nullopt;
}

CallOutcome outcome_of(const wire::Reply& reply, const std::string& executor) {
  if (reply.outcome == wire::Outcome::accepted) return {.reason = reply.reason};
  if (reply.outcome == wire::Outcome::pending)
    return {StreamError::command_timeout,
            {},
            0,
            executor + " did not accept or reject the command in time"};
  return {StreamError::refused, reply.refusal, reply.cause,
          std::string(name(reply.refusal)) + (reply.reason.empty() ? "" : ": ") + reply.reason};
}

namespace {

/// Sends the first command of a client. Another order owns the axis for some ms only: while the axis
/// is busy, repeats the command. A streamer owns it longer than that.
CallOutcome first_command(Client& client, const ClientCommand& command, std::int64_t at) {
  constexpr int attempts = 25;
  constexpr auto pause = 40ms;
  for (int attempt = 1;; ++attempt) {
    CallOutcome outcome = client.command(command, at);
    if (outcome.refusal != wire::Refusal::busy || attempt == attempts) return outcome;
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace

CallOutcome send_command(Transport& link, const std::string& executor, const ClientCommand& command,
                         std::int64_t at, const std::optional<wire::Key>& key, const Clock& clock) {
  if (is_operators(kind_of(command)))
    return outcome_of(
        operator_command(link, executor, wire::message_of(command, at), 2s, key, clock), executor);
  Client client(link, executor, {.key = key}, clock);
  CallOutcome outcome = first_command(client, command, at);
  static_cast<void>(client.release());
  return outcome;
}

std::optional<wire::Status> await_rest(Transport& link, const std::string& executor, Nanos patience,
                                       const std::optional<wire::Key>& key, const Clock& clock) {
  for (const Nanos begin = clock(); clock() - begin < patience;) {
    auto status = next_status_of(link, executor, 100ms, key, clock);
    if (status && is_at_rest(*status)) return status;
  }
  return std::nullopt;
}

namespace {

/// A wait of the owner of an axis for its rest.
class RestWait {
 public:
  RestWait(Client& client, const Clock& clock, Nanos patience)
      : client_(client), clock_(clock), end_(clock() + patience), heard_(clock()) {}

  [[nodiscard]] Nanos left() const { return end_ - clock_(); }

  /// Keeps the session. A session that has ended is the reason to report when the axis is at rest.
  /// Returns another failure that ends the wait.
  [[nodiscard]] std::optional<CallOutcome> keep() {
    if (client_.session() == 0) return std::nullopt;
    const CallOutcome alive = client_.keep(std::min<Nanos>(500ms, left()));
    if (alive.error == StreamError::stopped && alive.cause != 0) cut_short_ = alive;
    if (alive.error == StreamError::restarted) return alive;
    return std::nullopt;
  }

  [[nodiscard]] std::optional<CallOutcome> stop() {
    if (std::exchange(cancelled_, true)) return std::nullopt;
    if (CallOutcome stop = client_.stop(); !stop.ok()) return stop;
    cut_short_ = CallOutcome{StreamError::stopped, wire::Refusal::none,
                             static_cast<std::int32_t>(Cause::stopped), "the wait was cancelled"};
    return std::nullopt;
  }

  [[nodiscard]] std::optional<CallOutcome> silence(const std::string& executor, bool heard) {
    if (heard) heard_ = clock_();
    if (clock_() - heard_ <= longest_silence) return std::nullopt;
    return CallOutcome{
        StreamError::contact_lost, wire::Refusal::none, 0,
        "no status of " + executor + " for " + stream_detail::milliseconds(longest_silence)};
  }

  /// The outcome at rest.
  CallOutcome end(const wire::Status& status) {
    CallOutcome end = client_.end_of_motion(status);
    if (!end.ok() && !cut_short_)
      static_cast<void>(keep());  // a stop by an operator has ended the session, too
    if (!cut_short_) return end;
    cut_short_->reason += "; the axis rests at " + stream_detail::place_of(status);
    return *cut_short_;
  }

  CallOutcome late(Nanos patience) const {
    if (cut_short_) return *cut_short_;
    return {
        StreamError::out_of_time, wire::Refusal::none, 0,
        "not at rest within " + six_digits(std::chrono::duration<double>(patience).count()) + " s"};
  }

 private:
  static constexpr Nanos longest_silence = 2s;

  Client& client_;
  const Clock& clock_;
  Nanos end_, heard_;
  bool cancelled_ = false;
  std::optional<CallOutcome> cut_short_;
};

}  // namespace

RestOutcome await_rest(Transport& link, const std::string& executor, Client& client,
                       const RestOptions& options, const Clock& clock) {
  RestWait wait(client, clock, options.patience);
  while (wait.left() > Nanos{}) {
    std::optional<CallOutcome> failed = wait.keep();
    const auto status =
        next_status_of(link, executor, std::min<Nanos>(100ms, wait.left()), options.key, clock);
    if (!failed && status && is_at_rest(*status))
      return {wait.end(*status), status->state, status->slave_position};
    if (!failed) failed = wait.silence(executor, status.has_value());
    if (!failed && options.cancelled && options.cancelled()) failed = wait.stop();
    if (failed) return {*failed};
  }
  return {wait.late(options.patience)};
}

CallOutcome await_home(Transport& link, const std::string& executor, Client& client,
                       const std::function<bool()>& cancelled, const std::optional<wire::Key>& key,
                       const Clock& clock) {
  bool stopped = false;
  for (bool owns = true;;) {
    if (const auto status = next_status_of(link, executor, 50ms, key, clock)) {
      const bool moves = status->slave_velocity != 0;  // it may still brake, also in a fault
      const bool under_way = status->state == State::homing || moves;
      if (!under_way) return home_outcome(*status);
    }
    if (cancelled() && !std::exchange(stopped, true))
      if (const CallOutcome stop = client.stop(); !stop.ok()) return stop;
    const CallOutcome alive = owns ? client.keep() : CallOutcome{};
    owns = owns && alive.error != StreamError::stopped;  // the status states how the axis stopped
    if (owns && !alive.ok()) return alive;
  }
}

namespace {

/// The end of a jog by a fault, or by a stop of the axis, of its group or of an axis of the group: its
/// session goes on. nullopt: it moves, is held, or rests where its range ends.
std::optional<CallOutcome> early_end(const wire::Status& status) {
  if (!is_at_rest(status.state) || status.held || status.slave_velocity != 0) return std::nullopt;
  const std::int32_t number = status.last_error != 0 ? status.last_error : status.reason;
  const auto why = static_cast<Cause>(number);
  const bool stopped = why == Cause::stopped || why == Cause::group_stopped;
  if (status.last_error == 0 && !stopped) return std::nullopt;
  return CallOutcome{StreamError::stopped, wire::Refusal::none, number,
                     std::string("the jog has ended: ") + name(why) + ": " + meaning(why)};
}

/// Keeps the session of a hold-to-run jog that the axis has accepted.
CallOutcome keep_jogging(Transport& link, const std::string& executor, Client& client,
                         const ExecuteOptions& options, const Clock& clock) {
  if (options.held) options.held();
  CallOutcome outcome;
  bool moved = false;
  const Nanos begin = clock();
  const auto goes_on = [&] {
    return !(options.cancelled && options.cancelled()) &&
           (options.hold == Nanos{} || clock() - begin < options.hold);
  };
  while (outcome.ok() && goes_on()) {
    const Nanos next = clock() + 50ms;
    const auto status = next_status_of(link, executor, 50ms, options.key, clock);
    const auto end = status && moved ? early_end(*status) : std::nullopt;
    moved = moved || (status && !is_at_rest(status->state));
    if (const Nanos left = next - clock(); left > Nanos{}) std::this_thread::sleep_for(left);
    outcome = client.keep();
    if (outcome.ok() && end) outcome = *end;
  }
  return outcome;
}

}  // namespace

CallOutcome execute_command(Transport& link, const std::string& executor,
                            const ClientCommand& command, const ExecuteOptions& options,
                            const Clock& clock) {
  const bool homes = std::holds_alternative<command::Home>(command);
  if (!homes && !holds_to_run(command))
    return send_command(link, executor, command, options.at, options.key, clock);
  Client client(link, executor, {.key = options.key}, clock);
  CallOutcome outcome = first_command(client, command, options.at);
  const auto cancelled = [&] { return options.cancelled && options.cancelled(); };
  if (outcome.ok())
    outcome = homes ? await_home(link, executor, client, cancelled, options.key, clock)
                    : keep_jogging(link, executor, client, options, clock);
  static_cast<void>(client.release());
  return outcome;
}

StopResult stop_axis(Transport& link, const std::string& executor, wire::StopMode mode,
                     Nanos patience, const std::optional<wire::Key>& key, const Clock& clock) {
  if (!operator_stop(link, executor, mode, 2s, key, clock)) return {};
  const auto rest = await_rest(link, executor, patience, key, clock);
  return {true, rest ? std::optional(rest->state) : std::nullopt};
}

std::optional<std::int64_t> tick_after(Transport& link, const std::string& executor, double seconds,
                                       const std::optional<wire::Key>& key, const Clock& clock) {
  const auto status = present_status(link, executor, 2s, key, clock);
  if (!status) return std::nullopt;
  return status->tick + static_cast<std::int64_t>(std::llround(seconds * 1e9)) / status->cycle_ns;
}

}  // namespace jounce
