// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/base/detail/interrupt.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/machine/detail/command_words.hpp"
#include "jounce/machine/detail/outcome_text.hpp"
#include "jounce/machine/watch.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/operate.hpp"

#include "cli/common/json.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"
#include "cli/machine/outcome.hpp"

namespace jounce::cli {
namespace {

struct OrderArguments {
  std::string executor;
  CommandWords words;
  std::vector<std::string> values;  // after the command
  double seconds = 0;               // length of a hold-to-run jog; 0: until Ctrl-C
  std::string at;                   // "": at once
  LinkOptions link;
  bool json = false;
};

/// The state of the axis, and the units of the values of its commands.
wire::Status present(const OrderArguments& options, KeyedLink& link) {
  const auto status =
      present_status(link.transport(), options.executor, std::chrono::seconds(1), link.key());
  if (!status) dashboard::throw_missing(link, options.executor);
  return *status;
}

/// The names and units of the coordinates of a group, if the command has coordinates.
wire::GroupStatus coordinates_of(const OrderArguments& options, KeyedLink& link) {
  if (!names_axes(options.words) && !has_coordinates(options.words)) return {};
  const auto group =
      present_group(link.transport(), options.executor, std::chrono::seconds(1), link.key());
  if (!group && names_axes(options.words))
    throw InputError("NAME", options.executor, rule_of_axis(options.executor, options.words));
  return group.value_or(wire::GroupStatus{});
}

CallOutcome execute(const OrderArguments& options, KeyedLink& link, const Units& units) {
  const bool homes = options.words.what == "home";
  if (homes && !options.at.empty())
    throw InputError(
        "--at", options.at,
        "cannot be combined with home, which waits until the axis is homed: leave --at out");
  const wire::GroupStatus group = coordinates_of(options, link);
  const ClientCommand command = command_of(options.words, units, group.axes, group.units);
  std::optional<Interrupt> interrupt;
  if (homes || holds_to_run(command)) interrupt.emplace();
  return execute_command(
      link.transport(), options.executor, command,
      {.at = dashboard::tick_at(options.at, link, options.executor),
       .hold = nanos(options.seconds),
       .held =
           [&] {
             fmt::print("{}: jogs until Ctrl-C{}\n", options.executor,
                        options.seconds > 0 ? fmt::format(", or for {} s", options.seconds) : "");
             std::fflush(stdout);
           },
       .cancelled = [&] { return interrupt && interrupt->asked(); },
       .key = link.key()});
}

int report(const OrderArguments& options, const CallOutcome& outcome, const wire::Status& before) {
  const std::string& axis = options.executor;
  if (options.json)
    print_json(command_json(outcome));
  else if (outcome.ok())
    fmt::print("{}: {}\n", axis, accepted_text(options.words, before, axis, outcome.reason));
  else
    fmt::print(stderr, "jounce: {}: {}\n", axis, reason_text(outcome, options.words, before, axis));
  return status_of(outcome, {StreamError::refused});
}

int run_order(OrderArguments& options) {
  set_values(options.words, options.values);
  require_name_on_bus("NAME", options.executor);
  require_taken(options.words);
  if (options.seconds != 0) require_held(options.words, fmt::format("{}", options.seconds));
  KeyedLink link = open_link(options.link);
  const wire::Status before = present(options, link);
  return report(options, execute(options, link, before.units), before);
}

/// The options that the commands have.
void add_options(const Verb& verb, CommandWords& words) {
  for (const auto& [name, help, form, quantity, choices] : command_options()) {
    if (form == OptionForm::flag) {
      verb.flag("--" + name, words.flags[name], help);
      continue;
    }
    const Option option = verb.option("--" + name, words.options[name], help);
    if (!choices.empty()) option.check(one_of(choices));
    if (form != OptionForm::blend) continue;
    verb.flag("--buffered", words.flags["buffered"],
              "move, jog, and moves of a group: begin when the present motion has ended");
  }
}

/// Checks WHAT; a command in place of NAME is named.
ValueCheck command_word(const OrderArguments& options) {
  ValueCheck check = one_of(command_words());
  check.broken_rule = [&options, known = check.broken_rule](const std::string& what) {
    const std::string rule = known(what);
    const std::string meant = rule.empty() ? "" : meant_command(options.executor, what);
    return meant.empty() ? rule : meant;
  };
  return check;
}

}  // namespace

void add_order(CommandLine& line) {
  const auto options = std::make_shared<OrderArguments>();
  const Verb verb =
      line.verb("order", "Send one command to an axis or a group",
                "jounce order feeder move --to 120mm --velocity 200mm/s\n"
                "jounce order feeder move --by 80mm --blend next\n"
                "jounce order feeder jog -20mm/s --hold-to-run\n"
                "jounce order feeder inch 0.5mm --velocity 5mm/s\n"
                "jounce order plotter move-linear x=10mm y=5mm --velocity 80mm/s\n"
                "jounce order feeder override 50%\n"
                "jounce order feeder home --method 24 --search-velocity 40mm/s\n"
                "A number without a unit has the unit of the axis: mm, and mm/s for a velocity.");
  verb.option("NAME", options->executor, "Name of the axis or group").required();
  verb.option(
          "WHAT", options->words.what,
          fmt::format("{}. start plays the table of a virtual master, or the program of a group",
                      fmt::join(command_words(), ", ")))
      .required()
      .check(command_word(*options));
  verb.option(
      "VALUE", options->values,
      "Coordinates of a group (x=10mm y=5mm). Factor of override (50%), distance of inch, velocity "
      "of change-velocity, of jog (0: rest), position of set-position, ratio of gear-in, "
      "gear-in-pos, combine (3:2), time of wait (s), M word (6), trigger input of touch-probe (1)");
  add_options(verb, options->words);
  verb.option("--seconds", options->seconds, "End a --hold-to-run jog after this number of seconds")
      .check(seconds());
  verb.option("--at", options->at,
              "Tick of the executor (see `jounce monitor NAME --json`) at which the command takes "
              "effect, or +SECONDS from now; default: at once");
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Outcome as JSON");
  verb.work([options] { return run_order(*options); });
}

}  // namespace jounce::cli
