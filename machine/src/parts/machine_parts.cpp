// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/machine_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "jounce/axis/detail/homing_method.hpp"
#include "jounce/axis/machine.hpp"
#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/make.hpp"
#include "jounce/executor/detail/dispatcher.hpp"
#include "jounce/spec/axis_drive.hpp"

#include "machine/src/parts/axis_drive.hpp"
#include "machine/src/parts/machine_cutter.hpp"
#include "machine/src/parts/machine_groups.hpp"
#include "machine/src/parts/machine_masters.hpp"

namespace jounce {
namespace {

/// An axis as read from its file, and its leader with the place of that key.
struct Read {
  Spec spec;
  std::optional<FollowWhom> follow = {};
  const Document* said_in = nullptr;
  std::string key = {};
};

/// `unit`: one time unit of the spec, s.
HomingSpec homing_of(const AxisSpec::Homing& spec, double unit) {
  return {.method = spec.method,
          .search_velocity = spec.search_velocity / unit,
          .index_velocity = spec.index_velocity / unit,
          .acceleration = spec.acceleration / (unit * unit),
          .offset = spec.offset,
          .timeout = spec.timeout,
          .distance = spec.distance};
}

AxisConfig config_of(const Spec& spec) {
  const auto* axis = std::get_if<AxisSpec>(&spec.subject);
  if (axis == nullptr)
    throw spec.document.located(InputError(
        "kind", '"' + spec_kind(spec.document.text) + '"',
        "is not run by an executor: give a spec of kind \"axis\" or \"machine\" (`jounce new axis` "
        "writes an example), and send a motion to the axis with `jounce stream`"));
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
  if (axis->homing) config.homing = homing_of(*axis->homing, unit);
  config.require_home = axis->require_home;
  config.registration = axis->registration;
  if (axis->compensation) {
    const std::vector<std::string>& names = axis->compensation->axes;
    const auto own = std::find(names.begin(), names.end(), "");
    config.compensation = AxisCompensation{.table = axis->compensation->table};
    if (own != names.end())
      config.compensation->own = static_cast<std::size_t>(own - names.begin());
  }
  if (axis->longest_gap > 0) config.longest_gap = std::llround(axis->longest_gap / axis->cycle);
  return config;
}

/// After how long a silence an owner has lost the axis.
Nanos silence_of(const Spec& spec) {
  const double seconds = std::get<AxisSpec>(spec.subject).session_timeout;
  return Nanos(std::llround(seconds * 1e9));
}

std::function<void(const std::string&)> notice_of(const MachineOptions& options,
                                                  const ExecutorOptions& axis, std::size_t axes) {
  const std::string whose = axes == 1 ? "" : axis.receiver.executor + ": ";
  return [whose, notify = options.notify](const std::string& notice) { notify(whose + notice); };
}

/// Throws InputError for a homing method that needs a switch or an index, if no drive has one.
void require_sensors(const HomingSpec& homing, const std::optional<AxisDriveSpec>& drive) {
  const auto method = homing_method(homing.method);
  const bool ideal = !drive || (drive->type == AxisDriveSpec::Type::null && !drive->machine);
  if (!method || !ideal || has_sensors(*method, {})) return;
  throw InputError("homing.method", std::to_string(homing.method),
                   "needs a switch or an index, but this axis has no drive that reports one: add "
                   "[drive] with [drive.machine], or use method 35 or 37");
}

/// Throws InputError for a registration whose trigger input the drive does not have.
void require_marks(const std::optional<LiveRegistrationSpec>& registration,
                   const std::optional<AxisDriveSpec>& drive) {
  if (!registration) return;
  const std::vector<MachineMarks> marks =
      drive && drive->machine ? drive->machine->marks : std::vector<MachineMarks>{};
  const int probes = drive && drive->shared ? drive->shared->touch_probes : 0;
  const bool wired = registration->input <= probes ||
                     std::any_of(marks.begin(), marks.end(), [&](const MachineMarks& one) {
                       return one.input == registration->input;
                     });
  if (!wired)
    throw InputError(
        "registration.input", std::to_string(registration->input),
        "is a trigger input that the drive does not have: add "
        "[[drive.machine.marks]] with this input, or touch_probes to a drive in shared "
        "memory");
}

/// Throws InputError for a home position outside the position range. An axis without [homing] has the
/// home position 0, and only its command is rejected.
void require_home_inside(const HomingSpec& homing, const Limits& limits) {
  const auto no = misplaced_home(homing, limits);
  if (!no) return;
  const bool above = homing.offset > no->limit;
  throw InputError(
      "homing.offset", homing.offset,
      std::string(above ? "must be at most position_max, " : "must be at least position_min, ") +
          number(no->limit) + ": the axis stands there after the homing");
}

/// Throws InputError for limits that exclude the default of the start position.
void require_default_inside(const Spec& spec, const AxisConfig& config) {
  if (spec.document.places.contains("axis.position")) return;
  const std::string start = number(config.position);
  constexpr const char* remedy =
      ", the start position of the axis: change the limit, or add position to [axis]";
  if (const auto& most = config.limits.position_max; most && config.position > *most)
    throw InputError("limits.position_max", *most, "must be at least " + start + remedy);
  if (const auto& least = config.limits.position_min; least && config.position < *least)
    throw InputError("limits.position_min", *least, "must be at most " + start + remedy);
}

/// The configuration of an axis, checked against its drive.
AxisConfig axis_of(const Spec& spec) {
  AxisConfig config = config_of(spec);
  if (spec.name.empty())
    throw InputError(
        "name", "",
        "is missing: add name = \"NAME\", by which streams and commands address the axis");
  if (!wire::is_executor_name(spec.name))
    throw InputError("name", '"' + spec.name + '"', wire::executor_name_rule);
  require_default_inside(spec, config);
  (void)resolved(config);
  if (std::get<AxisSpec>(spec.subject).homing) require_home_inside(config.homing, config.limits);
  const auto drive = axis_drive(spec);
  require_sensors(config.homing, drive);
  require_marks(config.registration, drive);
  return config;
}

/// Returns the error of an axis at its place in the spec. The executor names its own fields, which the
/// spec has in [axis].
InputError in_axis_spec(const Spec& spec, const InputError& error) {
  const std::string key = "axis." + error.key();
  const bool is_own = spec.document.places.contains(key) || spec.document.known.contains(key);
  return spec.document.located(is_own ? InputError(key, error.value(), error.rule()) : error);
}

ExecutorOptions executor_of(const MachineOptions& options, const Spec& spec, std::size_t axes) {
  ExecutorOptions executor;
  executor.axis = axis_of(spec);
  executor.switches = spec.switches;
  if (spec.compare) {
    executor.compare = {spec.compare->of, spec.compare->compare};
    executor.compare.list->pulse *= seconds_per_unit(spec);
  }
  executor.units = {spec.master_unit, spec.units.position};
  executor.cutter = machine_detail::machine_cutter(spec, executor.axis);
  executor.receiver.executor = spec.name;
  executor.receiver.session_timeout = silence_of(spec);
  executor.adopt_start = options.adopt_start;
  executor.stop_when_silent = !options.finish_when_silent;
  executor.enable = options.enable;
  executor.build_apart = 2000;  // knots: about a millisecond
  if (!options.log.empty()) executor.log = log_of(options.log, spec.name, axes);
  const auto drive = axis_drive(spec);
  executor.logs_probes = drive && ((drive->machine && !drive->machine->marks.empty()) ||
                                   (drive->shared && drive->shared->touch_probes > 0));
  if (drive) executor.drive = make_drive(*drive, executor.axis, !options.without_drives);
  return executor;
}

std::optional<FollowWhom> follow_of(const Spec& spec) {
  const auto* axis = std::get_if<AxisSpec>(&spec.subject);
  return axis == nullptr ? std::nullopt : axis->follow;
}

/// A leader by name: its unit, and how an axis follows it.
struct Leader {
  std::string name;
  std::string unit;
  Follow follow = {};
};

std::string meant(const std::string& name, const std::vector<Leader>& leaders, const char* else_) {
  std::vector<std::string> names;
  for (const Leader& leader : leaders) names.push_back(leader.name);
  const std::string near = nearest(name, names);
  if (!near.empty()) return ": did you mean " + near + "?";
  return (names.empty() ? "" : ", which has " + listed(names)) + else_;
}

/// The leader with the names in the table `table` of the axis: "follow", "follow.second".
/// `converted`: the leader must have a unit of the same quantity as the master of the axis.
Follow resolved(const Read& axis, const FollowWhom& whom, const std::string& table, bool converted,
                const std::vector<Leader>& axes, const std::vector<Leader>& masters) {
  const bool of_master = !whom.master.empty();
  const std::string& name = of_master ? whom.master : whom.axis;
  const std::vector<Leader>& leaders = of_master ? masters : axes;
  const auto refuse = [&](const std::string& rule) {
    throw axis.said_in->located(
        InputError(axis.key + table + (of_master ? ".master" : ".axis"), name, rule));
  };
  const auto leader = std::find_if(leaders.begin(), leaders.end(),
                                   [&](const Leader& one) { return one.name == name; });
  if (leader == leaders.end() && of_master)
    refuse("is not a master of this machine" +
           meant(name, leaders, ": declare it in a spec of kind \"machine\", [master.NAME]"));
  if (leader == leaders.end())
    refuse("is not an axis of this machine" +
           meant(name, leaders, ": add the axis, or correct the name"));
  if (!of_master && name == axis.spec.name) refuse("is this axis itself: name another axis");
  const std::string& unit = axis.spec.master_unit;
  const bool converts = unit.empty() || unit == leader->unit || is_convertible(leader->unit, unit);
  if (!converts && converted)
    refuse("has the unit " + leader->unit + ", but the axis " + axis.spec.name +
           " has units.master = \"" + unit + "\" in its own spec: write \"" + leader->unit +
           "\" there, or follow something in " + unit);
  Follow follow = leader->follow;
  if (!unit.empty() && converts) follow.scale = conversion(leader->unit, unit);
  if (whom.actual) follow.what = Follow::What::actual;
  return follow;
}

/// Sets the leaders of an axis. Throws InputError for a registration without a master.
void set_leaders(ExecutorOptions& executor, const Read& axis, const std::vector<Leader>& axes,
                 const std::vector<Leader>& masters) {
  if (!axis.follow && executor.axis.registration)
    throw axis.spec.document.located(InputError(
        "registration", "", "needs a master: add [follow] to the axis or to its machine"));
  if (!axis.follow) return;
  executor.follow = resolved(axis, *axis.follow, "follow", true, axes, masters);
  executor.logs_profile = true;
  for (const FollowWhom& second : axis.follow->second)
    executor.second = resolved(axis, second, "follow.second", false, axes, masters);
}

/// Sets the references of the compensation of an axis: other axes of the machine by name, and the axis
/// itself.
void set_references(ExecutorOptions& executor, const Read& axis, std::size_t index,
                    const std::vector<Leader>& axes) {
  const auto& compensation = std::get<AxisSpec>(axis.spec.subject).compensation;
  for (std::size_t j = 0; compensation && j < compensation->axes.size(); ++j) {
    const std::string& name = compensation->axes[j];
    const auto refuse = [&](const char* key, const std::string& value, const std::string& rule) {
      throw axis.spec.document.located(
          InputError("compensation.reference[" + std::to_string(j + 1) + "]." + key, value, rule));
    };
    const auto other =
        std::find_if(axes.begin(), axes.end(), [&](const Leader& one) { return one.name == name; });
    if (!name.empty() && other == axes.end())
      refuse("axis", name,
             "is not an axis of this machine" +
                 meant(name, axes, ": name one of its axes, or add that axis to the machine"));
    if (!name.empty() && other->unit != compensation->units[j])
      refuse("unit", compensation->units[j], "must be " + other->unit + ", the unit of " + name);
    executor.references.push_back(name.empty() ? index : other->follow.index);
  }
}

/// A file that the machine's spec names.
Spec read_named(const MachineSpec::Axis& axis, const Document& document) {
  try {
    return read_spec(axis.spec);
  } catch (const InputError& error) {
    throw document.naming(axis.key + ".spec", axis.spec, error);
  }
}

std::vector<Read> read_axes(const MachineOptions& options,
                            const std::optional<MachineSpec>& machine) {
  std::vector<Read> read;
  if (machine) {
    for (const MachineSpec::Axis& axis : machine->axes) {
      Read one{.spec = read_named(axis, machine->document),
               .follow = axis.follow,
               .key = axis.key + "."};
      if (one.follow) one.said_in = &machine->document;
      read.push_back(std::move(one));
    }
  } else {
    for (const std::string& file : options.files) {
      if (options.files.size() > 1 && file != "-" && read_machine(file))
        throw InputError("kind", "\"machine\"", "names its axes itself: run it without other specs")
            .at(file);
      read.push_back({.spec = read_spec(file)});
    }
  }
  for (Read& one : read) {
    if (one.said_in != nullptr) continue;
    one.follow = follow_of(one.spec);
    one.said_in = &one.spec.document;
    one.key.clear();
  }
  return read;
}

/// The error of an axis in a machine, such as "y.cycle", at its place in the spec of the axis.
InputError in_spec_of_axis(const std::vector<Read>& axes, const InputError& error) {
  for (const Read& one : axes)
    if (error.key().starts_with(one.spec.name + "."))
      return one.spec.document.located(InputError("axis" + error.key().substr(one.spec.name.size()),
                                                  error.value(), error.rule()));
  return error;
}

/// Groups, and masters that play a table, are axes, too.
std::size_t virtual_axes(const std::optional<MachineSpec>& machine) {
  if (!machine) return 0;
  const auto& masters = machine->masters;
  const auto tables =
      std::count_if(masters.begin(), masters.end(), [](const MachineMasterSpec& one) {
        return std::holds_alternative<MachineMasterSpec::FromTable>(one.what);
      });
  return machine->groups.size() + static_cast<std::size_t>(tables);
}

/// The axes and masters of a machine, or of the axes in the files of the options.
MachineParts parts_of(const MachineOptions& options, const std::optional<MachineSpec>& machine) {
  const std::vector<Read> read = read_axes(options, machine);
  MachineParts parts;
  std::vector<Leader> axes;
  if (machine) parts.files = machine->document.all_files();
  for (const Read& one : read) {
    parts.add_files(one.spec.document.all_files());
    try {
      parts.axes.push_back(executor_of(options, one.spec, read.size() + virtual_axes(machine)));
    } catch (const InputError& error) {
      throw in_axis_spec(one.spec, error);
    }
    for (const Leader& other : axes)
      if (other.name == one.spec.name)
        throw one.spec.document.located(
            InputError("name", other.name,
                       "is also the name of another axis: rename one of them, and give each axis "
                       "its own spec"));
    if (const std::string& cutter = std::get<AxisSpec>(one.spec.subject).cutter; !cutter.empty())
      parts.files.push_back(machine_detail::cutter_path(one.spec, cutter));
    axes.push_back({one.spec.name,
                    one.spec.units.position,
                    {.what = Follow::What::setpoint, .index = axes.size()}});
  }
  std::vector<Leader> masters;
  if (machine) parts.watchdog = machine->watchdog;
  if (machine)
    for (const MachineMasterSpec& spec : machine->masters)
      masters.push_back(
          {spec.name, spec.unit,
           machine_detail::add_machine_master(spec, machine->document, options, parts)});
  if (machine)
    for (const MachineSpec::Group& group : machine->groups)
      machine_detail::add_machine_group(group, machine->document, options, parts);
  for (std::size_t i = 0; i < read.size(); ++i) {
    set_leaders(parts.axes[i], read[i], axes, masters);
    set_references(parts.axes[i], read[i], i, axes);
    for (const Follow& follow : {parts.axes[i].follow, parts.axes[i].second})
      if (follow.what == Follow::What::setpoint || follow.what == Follow::What::actual)
        parts.axes[follow.index].leads = true;
  }
  if (options.notify)
    for (auto& axis : parts.axes) axis.notify = notice_of(options, axis, parts.axes.size());
  try {
    (void)Machine(machine_of(parts.axes), parts.masters.size());
  } catch (const InputError& error) {  // the axes do not fit together
    const InputError placed = in_spec_of_axis(read, error);
    throw machine ? machine_detail::in_group(*machine, parts, placed) : placed;
  }
  return parts;
}

}  // namespace

std::string log_of(const std::string& log, const std::string& axis, std::size_t axes) {
  if (axes == 1) return log;
  std::filesystem::path path(log);
  const std::string extension = path.extension().string();
  return path.replace_extension("." + axis + extension).string();
}

void require_axis(const Spec& spec) {
  try {
    (void)executor_of({.without_drives = true}, spec, 1);
  } catch (const InputError& error) {
    throw in_axis_spec(spec, error);
  }
}

void require_machine(const MachineSpec& spec) {
  (void)parts_of({.without_drives = true}, spec);
}

MachineParts machine_parts(const MachineOptions& options) {
  std::optional<MachineSpec> machine;
  if (options.files.size() == 1) machine = read_machine(options.files.front());
  return parts_of(options, machine);
}

namespace {

/// Throws InputError for two outputs with one name.
void require_own_files(const MachineOptions& options, const RecorderOptions& record) {
  const std::array files{
      std::pair{"log", options.log}, std::pair{"record", record.log ? record.log->string() : ""},
      std::pair{"black_box", record.black_box ? record.black_box->string() : ""}};
  for (std::size_t i = 1; i < files.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!files[i].second.empty() && files[i].second == files[k].second)
        throw InputError(files[i].first, files[i].second,
                         "is also the file of another output: choose another name");
}

}  // namespace

void require_no_specs(const MachineOptions& options, const RecorderOptions& record) {
  require_own_files(options, record);
  for (const std::string& spec : options.files) {
    require_other_file(spec, options.log, "log");
    if (record.log) require_other_file(spec, record.log->string(), "record");
    if (record.black_box) require_other_file(spec, record.black_box->string(), "black_box");
  }
}

void require_no_inputs(const MachineOptions& options, const RecorderOptions& record,
                       const MachineParts& parts) {
  if (!options.log.empty())
    for (const auto& axis : parts.axes)
      require_no_input(parts.files, log_of(options.log, axis.receiver.executor, parts.axes.size()),
                       "log");
  if (record.log) require_no_input(parts.files, record.log->string(), "record");
  if (record.black_box) require_no_input(parts.files, record.black_box->string(), "black_box");
}

}  // namespace jounce
