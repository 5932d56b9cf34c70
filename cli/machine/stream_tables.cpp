// SPDX-License-Identifier: Apache-2.0
// Whole tables: to one axis, or to several of one machine, all or none.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/detail/interrupt.hpp"
#include "jounce/base/detail/progress_line.hpp"
#include "jounce/base/units.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/machine/watch.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/operate.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/machine/outcome.hpp"
#include "cli/machine/streaming.hpp"

namespace jounce::cli {
namespace {

PlayOptions play_options(const StreamArguments& options) {
  if (options.live && !options.master.empty())
    throw InputError("--master", options.master,
                     "cannot be combined with --live: the axis has its own master");
  PlayOptions play{.live = options.live,
                   .at_next_cut = options.at_next_cut,
                   .at_master = !options.start_at.empty(),
                   .keep_velocity = options.keep_velocity};
  if (!options.master.empty()) play.master = read_table(options.master);
  return play;
}

StreamGoal goal_of(const StreamArguments& options) {
  if (options.until == "download") return StreamGoal::download;
  return options.until == "arm" ? StreamGoal::arm : StreamGoal::start;
}

StreamPlan plan_of(const StreamArguments& options, const std::string& executor,
                   const Input& input) {
  const PlayOptions play = play_options(options);
  StreamPlan plan = with_option_names({"live", "master"}, [&] {
    StreamPlan made = stream_plan(executor, input, play);
    for (const std::string& file : options.swaps) add_swap(made, load(file, options.axis), play);
    return made;
  });
  plan.await = !options.no_wait;
  if (!options.start_at.empty()) {
    plan.when = StartAt::master_position;
    plan.position = under_option(
        "--start-at", [&] { return quantity(options.start_at, plan.tables.front().units.x); });
  }
  plan.goal = goal_of(options);
  return plan;
}

/// Patience, the key, and a Ctrl-C that stops what was armed.
StreamOptions stream_options(const StreamArguments& options, const KeyedLink& link,
                             const Interrupt& interrupt) {
  StreamOptions stream;
  stream.key = link.key();
  stream.total = nanos(options.patience);
  // Before the total time is over: "no answer" explains more than "time is up".
  stream.sender.patience = std::min(stream.sender.patience, stream.total * 3 / 4);
  stream.sender.command_patience = stream.total * 3 / 4;  // a group may plan a long path
  stream.cancelled = [&] { return interrupt.asked(); };
  return stream;
}

/// True for a follow spec with --live. One that waits for a position of its master needs --live.
bool is_live_follow(const Input& input, const StreamArguments& options) {
  if (const auto position = pass_position(input); position && !options.live)
    throw InputError("follow.pass", number(*position),
                     "is a position of a live master: stream it with --live");
  return options.live && is_follow(input);
}

/// Its tables, passes and event are played by the executor's two banks.
int stream_follow(const Input& input, const StreamArguments& options) {
  const bool other = !options.start_at.empty() || options.at_next_cut || options.keep_velocity ||
                     !options.swaps.empty() || options.until != "start" || !options.master.empty();
  if (other)
    throw InputError("FILE", options.file,
                     "is a follow spec, which defines its own start and end: omit --start-at, "
                     "--at-next-cut, --keep-velocity, --swap, --master and --until");
  const BankPlan plan = follow_bank_plan(input, options.relative);
  const bool waits = plan.queue.event == wire::QueueEvent::pass && options.no_wait;
  return play(plan, options,
              options.no_wait ? BankOptions::Until::accepted : BankOptions::Until::started,
              input.name, waits ? "waits for its master" : "started");
}

int report(const std::vector<std::string>& names, const std::vector<StreamOutcome>& outcomes,
           const StreamArguments& options, KeyedLink& link) {
  int status = fine;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const StreamOutcome& outcome = outcomes[i];
    status = std::max(status, status_of(outcome, {StreamError::refused, StreamError::dropped}));
    if (options.json) continue;
    if (outcome.ok())
      fmt::print("{}: {}\n", names[i], group_text(outcome, !options.no_wait));
    else
      fmt::print(stderr, "jounce: {}: {}\n", names[i],
                 dashboard::error_text(outcome, names[i], link));
  }
  if (options.json) print_json(group_json(names, outcomes));
  return status;
}

/// Event for which the start waits: "until its master passes 90 deg"; "": none.
std::string awaited_by(const StreamPlan& plan, const StreamArguments& options) {
  if (options.at_next_cut) return "for its next cut";
  if (!options.start_at.empty())
    return fmt::format("until its master passes {:.6g} {}", plan.position,
                       plan.tables.front().units.x);
  return plan.start_tick < 0 ? "" : fmt::format("for tick {}", plan.start_tick);
}

/// A path for a group: all of its axes.
std::optional<StreamPlan> group_plan(const StreamArguments& options, std::vector<Input>& axes) {
  auto plan = gcode_path_plan(options.to, options.file, options.machine, options.axis);
  if (!plan) axes = load_program(options.file, options.machine, options.axis);
  if (!plan && !is_path(axes)) return std::nullopt;
  const std::string alone = given_options({{"--live", options.live},
                                           {"--swap", !options.swaps.empty()},
                                           {"--master", !options.master.empty()}});
  if (!alone.empty())
    throw InputError("--to", options.to,
                     "receives all axes of the path: omit " + alone + ", or add --axis");
  if (!plan) plan = path_plan(options.to, axes);
  plan->await = !options.no_wait;
  plan->goal = goal_of(options);
  return plan;
}

}  // namespace

int stream_table(const StreamArguments& options) {
  std::vector<Input> axes;
  std::optional<StreamPlan> path = group_plan(options, axes);
  std::optional<Input> input;
  if (!path) input = only_one(std::move(axes), options.file);
  if (input && is_live_follow(*input, options)) return stream_follow(*input, options);
  if (options.relative)
    throw InputError("--relative", "",
                     "applies to --rolling, --bank and live follow specs only: other tables begin "
                     "at their first position");
  StreamPlan plan = path ? std::move(*path) : plan_of(options, options.to, *input);
  KeyedLink link = open_link(options.link);
  plan.start_tick = dashboard::tick_at(options.at, link, options.to);
  const Interrupt interrupt;
  StreamOptions stream = stream_options(options, link, interrupt);
  ProgressLine progress("streaming to " + options.to);
  std::string awaited = awaited_by(plan, options);
  stream.progress = [&](const StreamProgress& p) {
    progress.show(
        p.chunks == 0 ? 0 : static_cast<double>(p.arrived) / static_cast<double>(p.chunks),
        name(p.stage));
    if (p.stage != StreamStage::waiting || options.json || awaited.empty()) return;
    fmt::print(stderr, "jounce: {} waits {}{}{}; Ctrl-C cancels the start\n", options.to,
               std::exchange(awaited, ""), p.note.empty() ? "" : ": ", p.note);
  };
  StreamOutcome outcome = stream_tables(link.transport(), std::move(plan), stream);
  if (path) outcome.reason = with_file(outcome.reason, options.file);
  const bool waits = options.no_wait &&
                     (!options.start_at.empty() || options.at_next_cut || !options.swaps.empty());
  return report_outcome(outcome, options.to, options.json ? stream_json(outcome) : "",
                        stream_text(outcome, options.to, waits),
                        {StreamError::refused, StreamError::dropped}, link);
}

int stream_group(const StreamArguments& options) {
  const std::string alone = given_options({{"--rolling", options.rolling},
                                           {"--bank", !options.bank.empty()},
                                           {"--swap", !options.swaps.empty()},
                                           {"--start-at", !options.start_at.empty()},
                                           {"--at-next-cut", options.at_next_cut},
                                           {"--relative", options.relative},
                                           {"--until", options.until != "start"}});
  if (!alone.empty()) throw InputError("--to", options.to, "names several axes: omit " + alone);
  const std::vector<std::string> names =
      with_option_names({"to"}, [&] { return executor_names(options.to); });
  std::vector<StreamPlan> plans;
  const std::vector<Input> inputs = with_option_names({"to"}, [&] {
    return inputs_for(names, load_program(options.file, options.machine, options.axis),
                      options.file);
  });
  for (const Input& input : inputs) {
    if (is_live_follow(input, options))
      throw InputError(
          "--to", options.to,
          "names several axes, but a follow spec is for one axis: name that axis only");
    plans.push_back(plan_of(options, names[plans.size()], input));
  }
  KeyedLink link = open_link(options.link);
  const Interrupt interrupt;
  const StreamOptions stream = stream_options(options, link, interrupt);
  const GroupOptions group{.sender = stream.sender,
                           .tick = dashboard::tick_at(options.at, link, names.front()),
                           .watch = !options.no_wait};
  return report(names, jounce::stream_group(link.transport(), std::move(plans), group, stream),
                options, link);
}

}  // namespace jounce::cli
