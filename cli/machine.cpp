#include "machine.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "jounce/io/axis_drive.hpp"
#include "jounce/io/make.hpp"
#include "jounce/io/nearest.hpp"

#include "axis_drive.hpp"

namespace jounce::cli {
namespace {

/// An axis as its file has it, and whom it follows, with the place where that is said.
struct Read {
  Spec spec;
  std::optional<FollowWhom> follow = {};
  const Document* said_in = nullptr;
  std::string key = {};
};

AxisConfig config_of(const Spec& spec) {
  const auto* axis = std::get_if<AxisSpec>(&spec.subject);
  if (axis == nullptr)
    throw InputError("kind", "",
                     "an executor is configured by a spec of kind \"axis\"; see `jounce new axis`")
        .at(spec.document.name);
  const double unit = seconds_per_unit(spec);
  AxisConfig config;
  config.period = static_cast<std::int64_t>(std::llround(axis->cycle * 1e9));
  config.position = axis->position;
  config.limits = spec.limits;
  for (auto [limit, power] : {std::pair{&config.limits.velocity, 1},
                              {&config.limits.acceleration, 2},
                              {&config.limits.jerk, 3}})
    for (int i = 0; *limit && i < power; ++i) **limit /= unit;
  config.stop_acceleration = axis->stop_acceleration / (unit * unit);
  config.stop_jerk = axis->stop_jerk / (unit * unit * unit);
  config.abort_acceleration = axis->abort_acceleration / (unit * unit);
  config.limit_acceleration = axis->limit_acceleration / (unit * unit);
  config.modulo = axis->modulo;
  config.following_error = axis->following_error;
  config.following_time = axis->following_time;
  config.in_position = axis->in_position;
  config.in_position_time = axis->in_position_time;
  return config;
}

/// A terminal that does not take text must not hold up the executor: then it is dropped.
void say(const std::string& notice) {
  pollfd out{STDERR_FILENO, POLLOUT, 0};
  if (poll(&out, 1, 0) == 1 && (out.revents & POLLOUT) != 0) fmt::print(stderr, "{}\n", notice);
}

ExecutorOptions executor_of(const MachineOptions& options, const Spec& spec, std::size_t axes) {
  ExecutorOptions executor;
  executor.axis = config_of(spec);
  executor.switches = spec.switches;
  executor.units = {spec.master_unit, spec.units.position};
  executor.receiver.executor = spec.name;
  executor.adopt_start = options.adopt_start;
  executor.enable = options.enable;
  executor.build_apart = 2000;  // knots: about a millisecond
  if (!options.log.empty()) executor.log = log_of(options.log, spec.name, axes);
  const std::string whose = axes == 1 ? "" : spec.name + ": ";
  executor.notify = [whose](const std::string& notice) { say(whose + notice); };
  (void)resolved(executor.axis);
  if (const auto drive = axis_drive(spec)) executor.drive = make_drive(*drive, executor.axis);
  return executor;
}

std::optional<FollowWhom> follow_of(const Spec& spec) {
  const auto* axis = std::get_if<AxisSpec>(&spec.subject);
  return axis == nullptr ? std::nullopt : axis->follow;
}

Follow resolved(const Read& axis, const std::vector<Read>& all) {
  if (!axis.follow) return {};
  const auto refuse = [&](const char* what, const std::string& value, const std::string& rule) {
    throw axis.said_in->located(InputError(axis.key + what, value, rule));
  };
  const FollowWhom& whom = *axis.follow;
  if (!whom.master.empty())
    refuse("follow.master", whom.master,
           "no master of this name: this program has none from outside");
  std::vector<std::string> names;
  for (const Read& one : all) names.push_back(one.spec.name);
  const auto leader = std::find(names.begin(), names.end(), whom.axis);
  if (leader == names.end()) {
    const std::string near = nearest(whom.axis, names);
    refuse("follow.axis", whom.axis,
           "no axis of this name is run here" + (near.empty() ? std::string(": name its spec too")
                                                              : ". Did you mean " + near + "?"));
  }
  const auto index = static_cast<std::size_t>(leader - names.begin());
  const std::string& counts = all[index].spec.units.position;
  if (!axis.spec.master_unit.empty() && axis.spec.master_unit != counts)
    refuse("follow.axis", whom.axis,
           "it counts in " + counts + ", and this axis's units.master is " + axis.spec.master_unit);
  return {.what = whom.actual ? Follow::What::actual : Follow::What::setpoint, .index = index};
}

}  // namespace

std::string log_of(const std::string& log, const std::string& axis, std::size_t axes) {
  if (axes == 1) return log;
  std::filesystem::path path(log);
  const std::string extension = path.extension().string();
  return path.replace_extension("." + axis + extension).string();
}

std::vector<ExecutorOptions> axes_of(const MachineOptions& options) {
  std::optional<MachineSpec> machine;
  if (options.files.size() == 1) machine = read_machine(options.files.front());
  std::vector<Read> read;
  if (machine) {
    for (const MachineSpec::Axis& axis : machine->axes) {
      Read one{.spec = read_spec(axis.spec), .follow = axis.follow, .key = axis.key + "."};
      if (one.follow) one.said_in = &machine->document;
      read.push_back(std::move(one));
    }
  } else {
    for (const std::string& file : options.files) read.push_back({.spec = read_spec(file)});
  }
  for (Read& one : read) {
    if (one.said_in != nullptr) continue;
    one.follow = follow_of(one.spec);
    one.said_in = &one.spec.document;
    one.key.clear();
  }
  std::vector<ExecutorOptions> axes;
  for (const Read& one : read) {
    try {
      axes.push_back(executor_of(options, one.spec, read.size()));
    } catch (const InputError& error) {
      // The executor names its own fields, which the spec has in [axis].
      const std::string key = "axis." + error.key();
      throw one.spec.document.located(one.spec.document.places.contains(key)
                                          ? InputError(key, error.value(), error.rule())
                                          : error);
    }
    axes.back().follow = resolved(one, read);
  }
  return axes;
}

}  // namespace jounce::cli
