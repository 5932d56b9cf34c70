// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "jounce/machine/detail/dashboard.hpp"
#include "jounce/machine/detail/outcome_text.hpp"
#include "jounce/machine/detail/status_text.hpp"
#include "jounce/machine/detail/terminal.hpp"

#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {
namespace {

constexpr Nanos turn = std::chrono::milliseconds(50);

struct MonitorArguments {
  std::vector<std::string> executors;  // empty: all that send messages
  LinkOptions link;
  double seconds = 0;
  double silence = 3;
  bool ascii = false, json = false, events = false;
  std::string until;
};

using dashboard::Watch;

/// `who`: see Watch::silent().
int give_up(const std::string& who, double seconds, const std::string& url, KeyedLink& link) {
  const std::string what = who == dashboard::any_executor ? "no executor has sent a message"
                                                          : who + " has sent no message";
  fmt::print(stderr, "jounce: {} for {} s on {}: {}\n", what, seconds, url,
             who == dashboard::any_executor ? unheard_hint : dashboard::senders_hint(link));
  return fault;
}

int print_all(Watch& watch, const MonitorArguments& options, KeyedLink& link) {
  const auto print = [&](const std::string& axis, const auto& status, const auto&... unit) {
    fmt::print("{}\n",
               options.json ? status_json(axis, status) : status_text(axis, status, unit...));
    std::fflush(stdout);
  };
  const auto print_group = [&](const std::string& group, const wire::GroupStatus& status) {
    print(group, status, watch.unit_of(group));
  };
  for (const Duration duration(options.seconds); duration.goes_on();) {
    options.events ? watch.run(turn, {}, {}, print)
                   : watch.run(turn, print, print, {}, print_group);
    if (const std::string who = watch.silent(nanos(options.silence)); !who.empty())
      return give_up(who, options.silence, options.link.url, link);
  }
  const std::string who = watch.missing();
  return who.empty() ? fine : give_up(who, options.seconds, options.link.url, link);
}

std::vector<std::string> state_words() {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < states; ++i) words.emplace_back(name(static_cast<State>(i)));
  return words;
}

/// Waits until all axes are in the state `until`, and prints their last statuses.
int wait_for(Watch& watch, const MonitorArguments& options, KeyedLink& link) {
  const State wanted = *state_of(options.until);
  const dashboard::Watched* other = nullptr;
  for (const Duration duration(options.seconds); duration.goes_on();) {
    watch.run(turn);
    other = watch.outside(wanted);
    const bool failed = other != nullptr && other->status->state == State::error_stop;
    if (failed || (other == nullptr && watch.missing().empty())) break;
    if (const std::string who = watch.silent(nanos(options.silence)); !who.empty())
      return give_up(who, options.silence, options.link.url, link);
  }
  if (const std::string who = watch.missing(); !who.empty())
    return give_up(who, options.seconds, options.link.url, link);
  for (const dashboard::Watched& axis : watch.axes())
    fmt::print("{}\n", options.json ? status_json(axis.name, *axis.status)
                                    : status_text(axis.name, *axis.status));
  if (other == nullptr) return fine;
  fmt::print(stderr, "jounce: {} is in the state {}, not {}\n", other->name,
             name(other->status->state), options.until);
  return finding;
}

int run_monitor(const MonitorArguments& options) {
  for (const std::string& name : options.executors) require_name_on_bus("NAME", name);
  KeyedLink link = open_link(options.link);
  Watch watch(link.transport(), {.names = options.executors, .key = link.key()});
  if (!options.until.empty()) return wait_for(watch, options, link);
  if (options.json || options.events || !dashboard::is_screen())
    return print_all(watch, options, link);
  const dashboard::View view{.ascii = options.ascii || !dashboard::is_utf8(),
                             .silence = nanos(options.silence)};
  const Duration duration(options.seconds);
  const bool received =
      show_axes(watch, link.transport(), view, link.key(), [&] { return duration.goes_on(); });
  return received ? fine
                  : give_up(watch.silent(view.silence), options.silence, options.link.url, link);
}

}  // namespace

void add_monitor(CommandLine& line) {
  const auto options = std::make_shared<MonitorArguments>();
  const Verb verb = line.verb(
      "monitor", "Show the present state of axes and groups",
      "jounce monitor                           all executors\n"
      "jounce monitor feeder knife\n"
      "jounce monitor feeder --seconds 10 --json > feeder.jsonl\n"
      "jounce monitor feeder --until standstill --seconds 60    wait until it is at rest\n"
      "Keys: up and down choose an axis, h holds, r resumes, s and then y stops it, q quits.\n"
      "Output to a file or a pipe has one line for each status. late cycles: number of cycles that "
      "began a whole period late or more, since the executor started.");
  const Option names = verb.option("NAME", options->executors,
                                   "Names of axes and groups; default: all that send messages");
  verb.option("--seconds", options->seconds,
              "End after this number of seconds; default: run until q or Ctrl-C")
      .check(seconds());
  verb.option("--silence", options->silence,
              "End when no message arrives for this number of seconds; on a terminal, only before "
              "the first message")
      .check(seconds())
      .shown();
  const Option until =
      verb.option("--until", options->until,
                  "End with exit status 0 when the axes NAME are in this state; with 1 "
                  "after --seconds, or if one of them is in error_stop")
          .check(one_of(state_words()))
          .needs(names);
  add_link_options(verb, options->link);
  verb.flag("--ascii", options->ascii,
            "Draw bars and plots in ASCII; default: depends on the locale");
  verb.flag("--json", options->json, "One line of JSON for each status");
  until.excludes({verb.flag("--events", options->events,
                            "Print events (probes, marks, outputs, ends of cams), not statuses")});
  verb.work([options] { return run_monitor(*options); });
}

}  // namespace jounce::cli
