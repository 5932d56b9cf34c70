// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/command/command_table.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/client.hpp"

#include "cli/common/interrupt.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/await_home.hpp"
#include "cli/machine/link.hpp"
#include "cli/machine/order_words.hpp"

namespace jounce::cli {
namespace {

struct OrderArguments {
  std::string executor;
  OrderWords words;
  double seconds = 0;  // length of a hold-to-run jog; 0: until Ctrl-C
  std::int64_t at = -1;
  LinkOptions link;
  bool json = false;
};

/// The units of the axis, and of the values of its commands.
Units units_of(Transport& link, const OrderArguments& options,
               const std::optional<wire::Key>& key) {
  link.subscribe(wire::channel(options.executor, wire::Lane::status), 1);
  const auto message =
      next_status(link, options.executor, std::chrono::seconds(1), steady_now, key);
  if (!message) {
    throw TransportError("no message from " + options.executor + ": " + unheard_hint);
  }
  return std::get<wire::Status>(message->body).units;
}

/// Keeps the session of a hold-to-run jog, so long as it is held.
CallOutcome hold(const OrderArguments& options, Client& client) {
  constexpr auto between = std::chrono::milliseconds(50);
  fmt::print("{}: jogs until Ctrl-C{}\n", options.executor,
             options.seconds > 0 ? fmt::format(", or for {} s", options.seconds) : "");
  std::fflush(stdout);
  const Interrupt interrupt;
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(options.seconds);
  CallOutcome outcome;
  while (outcome.ok() && !interrupt.asked() &&
         (options.seconds == 0 || std::chrono::steady_clock::now() < end)) {
    std::this_thread::sleep_for(between);
    outcome = client.beat();
  }
  return outcome;
}

/// Commands of an operator need no session: another session may own the axis.
CallOutcome give(const OrderArguments& options, const ClientCommand& command, Link& link) {
  if (!is_operators(kind_of(command))) {
    Client client(link.transport(), options.executor, {.key = link.key()});
    CallOutcome outcome = client.command(command, options.at);
    if (holds_to_run(command) && outcome.ok()) outcome = hold(options, client);
    if (std::holds_alternative<command::Home>(command) && outcome.ok())
      outcome = await_home(options.executor, client, link);
    static_cast<void>(client.release());
    return outcome;
  }
  const wire::Reply reply = operator_command(link.transport(), options.executor,
                                             wire::message_of(command, options.at), link.key());
  if (reply.outcome == wire::Outcome::accepted) return {};
  if (reply.outcome == wire::Outcome::pending)
    return {StreamError::command_timeout,
            {},
            0,
            options.executor + " did not accept or reject the command in time"};
  return {StreamError::refused, reply.refusal, reply.cause,
          std::string(name(reply.refusal)) + (reply.reason.empty() ? "" : ": ") + reply.reason};
}

int report(const OrderArguments& options, const CallOutcome& outcome) {
  if (options.json) {
    const nlohmann::ordered_json document{{"ok", outcome.ok()},
                                          {"error", name(outcome.error)},
                                          {"cause", outcome.cause},
                                          {"reason", outcome.reason}};
    fmt::print("{}\n", document.dump(1));
  } else if (outcome.ok()) {
    fmt::print("{}: {}\n", options.executor,
               options.words.what == "home" ? "homed" : options.words.what + " accepted");
  } else {
    fmt::print(stderr, "jounce: {}: {}\n", options.executor, outcome.reason);
  }
  if (outcome.ok()) return fine;
  return outcome.error == StreamError::refused ? finding : fault;
}

int run_order(const OrderArguments& options) {
  require_name_on_bus("NAME", options.executor);
  require_taken(options.words);
  Link link(options.link);
  const Units units = units_of(link.transport(), options, link.key());
  if (options.words.what == "home" && options.at >= 0)
    throw InputError("--at", std::to_string(options.at),
                     "cannot be combined with home, which waits until the axis is homed");
  return report(options, give(options, command_of(options.words, units), link));
}

/// The options that the commands have.
void add_options(const Verb& verb, OrderWords& words) {
  for (const auto& [name, help, range] : order_options()) {
    if (range == FieldRange::flag) {
      verb.flag("--" + name, words.flags[name], help);
      continue;
    }
    const Option option = verb.option("--" + name, words.options[name], help);
    if (range == FieldRange::direction) option.check(one_of({"shortest", "positive", "negative"}));
    if (range != FieldRange::buffer_mode) continue;
    option.check(one_of({"low", "previous", "next", "high"}));
    verb.flag("--buffered", words.flags["buffered"],
              "move --to, --by and jog: begin when the present motion has ended");
  }
}

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace

void add_order(CommandLine& line) {
  const auto options = std::make_shared<OrderArguments>();
  const Verb verb = line.verb("order", "Send one command to an axis",
                              "jounce order feeder move --to 120mm --velocity 200mm/s\n"
                              "jounce order feeder move --by 80mm --blend next\n"
                              "jounce order feeder jog -20mm/s --hold-to-run\n"
                              "jounce order feeder inch 0.5mm --velocity 5mm/s\n"
                              "jounce order feeder override 50%\n"
                              "jounce order feeder home --method 24 --search-velocity 40mm/s\n"
                              "Numbers without a unit have the unit of the axis.");
  verb.option("NAME", options->executor, "Name of the executor").required();
  verb.option("WHAT", options->words.what, listed(order_words()) + " (the axis's own table)")
      .required()
      .check(one_of(order_words()));
  verb.option("VALUE", options->words.value,
              "Factor of override (50%), distance of inch, velocity of jog (0: to rest), position "
              "of set-position, ratio of gear-in and gear-in-pos (3:2)");
  add_options(verb, options->words);
  verb.option("--seconds", options->seconds, "End a --hold-to-run jog after this number of seconds")
      .check(seconds());
  verb.option("--at", options->at,
              "Tick of the executor at which the command takes effect; default: at once")
      .check(whole(0, std::numeric_limits<std::int64_t>::max()));
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Outcome as JSON");
  verb.work([options] { return run_order(*options); });
}

}  // namespace jounce::cli
