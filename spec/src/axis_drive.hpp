// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/spec/axis_drive.hpp"
#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::detail {

/// [drive] with what an axis's executor needs of it; also `spec`, `name` and so on.
std::optional<AxisDriveSpec> read_axis_drive(TomlReader& top, const Units& units);

/// The keys of a drive behind shared memory.
AxisDriveSpec::Shared read_shared(TomlReader& table, const Units& units);

/// [drive.machine]: the switches and the index of a machine that is not there.
std::optional<MachineSensorsSpec> read_machine_sensors(TomlReader& drive, const Units& units);

/// A [drive] of which its owner may have read keys of its own.
DriveSpec read_drive_table(TomlReader& table, const Units& units);

}  // namespace jounce::detail
