// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/machine/detail/outcome_text.hpp"
#include "jounce/machine/watch.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/operate.hpp"

#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {
namespace {

struct StopArguments {
  std::string executor;
  LinkOptions link;
  bool abort = false;
  double patience = 10;
};

int run_stop(const StopArguments& options) {
  require_name_on_bus("NAME", options.executor);
  KeyedLink link = open_link(options.link);
  const auto mode = options.abort ? wire::StopMode::abort : wire::StopMode::stop;
  const StopResult result =
      stop_axis(link.transport(), options.executor, mode, nanos(options.patience), link.key());
  if (result.rest)
    fmt::print("{}\n", stopped_text(options.executor, *result.rest));
  else if (result.confirmed)
    fmt::print(stderr, "jounce: {} confirms the stop, but is not at rest after {} s\n",
               options.executor, options.patience);
  else
    fmt::print(stderr, "jounce: {} does not confirm the stop: {}\n", options.executor,
               dashboard::senders_hint(link));
  return result.rest ? fine : fault;
}

}  // namespace

void add_stop(CommandLine& line) {
  const auto options = std::make_shared<StopArguments>();
  const Verb verb = line.verb("stop", "Stop an axis or a group, even if another program moves it",
                              "jounce stop feeder\n"
                              "jounce stop feeder --abort");
  verb.option("NAME", options->executor, "Name of the axis or group").required();
  verb.flag("--abort", options->abort,
            "Abort: freeze the setpoint at once, or brake with abort_acceleration, even off the "
            "path. The axis is then in error_stop");
  verb.option("--patience", options->patience, "Wait at most this number of seconds for standstill")
      .check(seconds())
      .shown();
  add_link_options(verb, options->link);
  verb.work([options] { return run_stop(*options); });
}

}  // namespace jounce::cli
