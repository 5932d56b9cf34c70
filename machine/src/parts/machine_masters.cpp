// SPDX-License-Identifier: Apache-2.0
#include "machine/src/parts/machine_masters.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "jounce/axis/master.hpp"
#include "jounce/design/detail/executor_tables.hpp"
#include "jounce/drive/encoder.hpp"
#include "jounce/drive/shared_drive.hpp"
#include "jounce/profiles/error.hpp"

#include "machine/src/parts/axis_drive.hpp"

namespace jounce::machine_detail {
namespace {

TrackerSpec tracker_of(const TrackingSpec& t) {
  return {.velocity = t.velocity,
          .acceleration = t.acceleration,
          .time_constant = t.time_constant,
          .order = t.order,
          .settle = t.settle,
          .latency = t.latency,
          .longest_age = t.longest_age,
          .jump = t.jump,
          .modulo = t.modulo};
}

ExecutorOptions* axis_named(const std::string& name, MachineParts& parts) {
  const auto axis = std::find_if(parts.axes.begin(), parts.axes.end(),
                                 [&](const auto& one) { return one.receiver.executor == name; });
  return axis == parts.axes.end() ? nullptr : &*axis;
}

/// Returns the reader of an encoder, which is called once in every cycle.
std::function<double()> reader_of(const MachineMasterSpec& spec,
                                  const MachineMasterSpec::Encoder& encoder, bool opens,
                                  MachineParts& parts) {
  const EncoderErrors errors{encoder.resolution, encoder.noise, encoder.seed};
  const auto reading = std::make_shared<EncoderReading>(errors);
  if (encoder.drive) {
    AxisDriveSpec alone{.type = AxisDriveSpec::Type::shared_memory, .shared = encoder.drive};
    const std::shared_ptr<AxisDrive> drive = make_drive(alone, {}, opens);
    return [drive, reading] { return (*reading)(reported_position(drive->feedback())); };
  }
  ExecutorOptions* const axis = axis_named(encoder.axis, parts);
  if (axis == nullptr) throw InputError("axis", encoder.axis, "is not an axis of this machine");
  if (!axis->drive)
    throw InputError("axis", encoder.axis,
                     "has no [drive], so it has no actual position: add [drive], such as type = "
                     "\"null\", a drive without following error");
  if (!axis->units.position.empty() && axis->units.position != spec.unit)
    throw InputError("unit", spec.unit,
                     "must be " + axis->units.position + ", the unit of the axis");
  const auto observed = std::make_shared<ObservedDrive>(axis->drive);
  axis->drive = observed;
  return [observed, reading] { return (*reading)(observed->position()); };
}

Follow add(std::shared_ptr<Master> source, const MachineMasterSpec& spec, MachineParts& parts) {
  parts.masters.push_back({spec.name, spec.unit, std::move(source)});
  return {.what = Follow::What::master, .index = parts.masters.size() - 1};
}

Follow make(const MachineMasterSpec::External& external, const MachineMasterSpec& spec,
            const MachineOptions& /*options*/, MachineParts& parts) {
  return add(std::make_shared<ExternalMaster>(tracker_of(external.tracking)), spec, parts);
}

Follow make(const MachineMasterSpec::Encoder& encoder, const MachineMasterSpec& spec,
            const MachineOptions& options, MachineParts& parts) {
  const TrackerSpec tracker = tracker_of(encoder.tracking);
  require_valid(tracker);
  return add(std::make_shared<EncoderMaster>(
                 tracker, reader_of(spec, encoder, !options.without_drives, parts)),
             spec, parts);
}

/// The file's motion in s, in the master's unit.
StoredTable stored(const MachineMasterSpec::FromTable& own, const std::string& unit,
                   MachineParts& parts) {
  const std::vector<Input> inputs = read_inputs(own.file);
  parts.add_files(files_of(inputs));
  if (inputs.size() > 1)
    throw InputError("file", own.file, "must have one axis, not " + std::to_string(inputs.size()));
  ExecutorTables tables = executor_tables(inputs.front());
  if (tables.master || tables.slave.table.axis() != Domain::time)
    throw InputError("file", own.file, "must be over time: a master is a function of time");
  const Units units = tables.slave.units;
  if (units.position != unit)
    throw InputError(
        "file", own.file,
        "has the unit " + units.position + ", but this master has " + unit + ": use the same unit");
  const auto table = std::make_shared<const Table>(std::move(tables.slave.table));
  return {content_hash(*table, units), units, table};
}

/// A virtual axis, which stands where its table begins.
Follow make(const MachineMasterSpec::FromTable& own, const MachineMasterSpec& spec,
            const MachineOptions& options, MachineParts& parts) {
  const ExecutorOptions& first = parts.axes.front();
  ExecutorOptions axis;
  axis.table = stored(own, spec.unit, parts);
  axis.axis.period = first.axis.period;
  axis.axis.longest_gap = first.axis.longest_gap;
  axis.axis.position = axis.table->table->jet(axis.table->table->start())[0];
  axis.axis.limits = own.limits;
  axis.units = {"", spec.unit};
  axis.receiver.executor = spec.name;
  axis.receiver.session_timeout = first.receiver.session_timeout;
  axis.enable = first.enable;
  axis.stop_when_silent = first.stop_when_silent;
  axis.build_apart = first.build_apart;
  // Never alone: at least one axis is there besides.
  if (!options.log.empty()) axis.log = log_of(options.log, spec.name, 2);
  (void)resolved(axis.axis);
  parts.axes.push_back(std::move(axis));
  return {.what = Follow::What::setpoint, .index = parts.axes.size() - 1};
}

std::string named_file(const MachineMasterSpec& spec) {
  const auto* const own = std::get_if<MachineMasterSpec::FromTable>(&spec.what);
  return own == nullptr ? "" : own->file;
}

}  // namespace

Follow add_machine_master(const MachineMasterSpec& spec, const Document& document,
                          const MachineOptions& options, MachineParts& parts) {
  if (axis_named(spec.name, parts) != nullptr)
    throw document.located(
        InputError(spec.key, spec.name, "is also the name of an axis of this machine: rename one"));
  try {
    return std::visit([&](const auto& what) { return make(what, spec, options, parts); },
                      spec.what);
  } catch (const InputError& error) {
    if (!error.document().empty())  // an error of another file, or a missing file
      throw document.naming(spec.key + ".file", named_file(spec), error);
    throw document.located(InputError(spec.key + "." + error.key(), error.value(), error.rule()));
  }
}

}  // namespace jounce::machine_detail
