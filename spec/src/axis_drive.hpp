// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/spec/axis_drive.hpp"
#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::spec_detail {

/// Reads the part of [drive] that the executor of an axis needs. The same table also has the keys
/// of the model, or of another file.
std::optional<AxisDriveSpec> read_axis_drive(TomlReader& top, const Units& units,
                                             const std::string& master_unit);

/// Reads the keys of a drive in shared memory.
AxisDriveSpec::Shared read_shared(TomlReader& table, const Units& units);

/// Reads [drive.machine]: the switches, the index and the marks of a simulated machine.
std::optional<MachineSensorsSpec> read_machine_sensors(TomlReader& drive, const Units& units,
                                                       const std::string& master_unit);

/// Reads a [drive]. The caller may have read further keys of the table before.
DriveSpec read_drive_table(TomlReader& table, const Units& units);

}  // namespace jounce::spec_detail
