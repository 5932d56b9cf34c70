// SPDX-License-Identifier: Apache-2.0
#include "machine/src/parts/axis_drive.hpp"

#include <utility>

#include "jounce/drive/machine_sensors.hpp"
#include "jounce/drive/shared_drive.hpp"
#include "jounce/drive/simulated_drive.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::shared_ptr<AxisDrive> make(const AxisDriveSpec& spec, const AxisConfig& axis, bool opens) {
  switch (spec.type) {
    case AxisDriveSpec::Type::null:
      return std::make_shared<NullDrive>(axis.position);
    case AxisDriveSpec::Type::simulated:
      return std::make_shared<SimulatedDrive>(*spec.model, static_cast<double>(axis.period) * 1e-9,
                                              axis.position);
    case AxisDriveSpec::Type::shared_memory:
      break;
  }
  const AxisDriveSpec::Shared& shared = *spec.shared;
  const Cia402Config config{.increments_per_rev = shared.increments_per_rev,
                            .position_per_rev = shared.position_per_rev,
                            .reversed = shared.reversed,
                            .window = shared.window,
                            .touch_probes = shared.touch_probes};
  if (opens) return std::make_shared<SharedDrive>(shared.name, config, shared.silent_cycles);
  require_shared_drive(shared.name, config);
  return std::make_shared<NullDrive>(axis.position);
}

}  // namespace

std::shared_ptr<AxisDrive> make_drive(const AxisDriveSpec& spec, const AxisConfig& axis,
                                      bool opens) {
  try {
    auto drive = make(spec, axis, opens);
    if (!spec.machine) return drive;
    return std::make_shared<DriveOnMachine>(std::move(drive), *spec.machine,
                                            static_cast<double>(axis.period) * 1e-9);
  } catch (const InputError& error) {  // a drive names its own numbers
    throw InputError("drive." + error.key(), error.value(), error.rule());
  }
}

}  // namespace jounce
