// SPDX-License-Identifier: Apache-2.0
// `jounce stream --to a,b,c`: several axes of one machine, all or none.
#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/group.hpp"

#include "cli/common/verb.hpp"
#include "cli/stream/stream_options.hpp"

namespace jounce::cli {
namespace {

std::vector<std::string> names_of(const std::string& list) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    names.push_back(list.substr(from, comma - from));
    from = comma + 1;
  }
  for (const std::string& name : names) require_name_on_bus("--to", name);
  return names;
}

/// The axes of the file for these executors: one for all of them, or each its own, by name where the
/// names are the same, otherwise in order.
std::vector<Input> inputs_for(const std::vector<std::string>& names, const StreamVerb& options) {
  const std::vector<Input> all = load_axes(options.file, options.axis);
  std::vector<Input> chosen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto named = std::find_if(all.begin(), all.end(),
                                    [&](const Input& input) { return input.axis == names[i]; });
    if (all.size() == 1)
      chosen.push_back(all.front());
    else if (named != all.end())
      chosen.push_back(*named);
    else if (all.size() == names.size())
      chosen.push_back(all[i]);
    else
      throw InputError("--to", options.to,
                       "names " + std::to_string(names.size()) + " axes, but " + options.file +
                           " has " + std::to_string(all.size()) +
                           ": name one executor for each axis");
  }
  return chosen;
}

int report(const std::vector<std::string>& names, const std::vector<StreamOutcome>& outcomes,
           const StreamVerb& options) {
  nlohmann::ordered_json document = nlohmann::ordered_json::array();
  int status = fine;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const StreamOutcome& outcome = outcomes[i];
    const bool said_no = outcome.error == StreamError::refused ||
                         outcome.error == StreamError::dropped ||
                         outcome.error == StreamError::stopped;
    if (!outcome.ok()) status = std::max<int>(status, said_no ? finding : fault);
    if (options.json)
      document.push_back({{"axis", names[i]},
                          {"ok", outcome.ok()},
                          {"error", name(outcome.error)},
                          {"reason", outcome.reason},
                          {"started", outcome.started},
                          {"stopped", outcome.stopped}});
    else if (!outcome.ok())
      fmt::print(stderr, "jounce: {}: {}\n", names[i], said_of(outcome.error, outcome.reason));
    else
      fmt::print("{}: {}\n", names[i],
                 outcome.stopped   ? "stopped"
                 : options.no_wait ? "started"
                                   : "finished");
  }
  if (options.json) fmt::print("{}\n", document.dump(1));
  return status;
}

}  // namespace

int stream_group(const StreamVerb& options) {
  const bool alone = options.rolling || !options.bank.empty() || !options.swaps.empty() ||
                     !options.start_at.empty() || options.at_next_cut || options.relative ||
                     options.until != "start";
  if (alone)
    throw InputError("--to", options.to,
                     "names several axes: omit --rolling, --bank, --swap, --start-at, "
                     "--at-next-cut, --relative and --until");
  const std::vector<std::string> names = names_of(options.to);
  std::vector<StreamPlan> plans;
  for (Input& input : inputs_for(names, options)) {
    if (is_live_follow(input, options))
      throw InputError("--to", options.to,
                       "names several axes: stream a follow spec to one of them");
    plans.push_back(plan_of(options, names[plans.size()], std::move(input)));
  }
  Link link(options.link);
  GroupOptions group{.tick = tick_of(options, link, names.front()), .watch = !options.no_wait};
  const StreamOptions stream = stream_options(options, link);
  group.sender = stream.sender;
  return report(names, jounce::stream_group(link.transport(), std::move(plans), group, stream),
                options);
}

}  // namespace jounce::cli
