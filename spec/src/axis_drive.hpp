// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/spec/axis_drive.hpp"
#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::spec_detail {

/// [drive], as far as the executor of an axis needs it; also `spec`, `name` and so on.
std::optional<AxisDriveSpec> read_axis_drive(TomlReader& top, const Units& units);

/// The keys of a drive behind shared memory.
AxisDriveSpec::Shared read_shared(TomlReader& table, const Units& units);

/// [drive.machine]: the switches and the index of a simulated machine.
std::optional<MachineSensorsSpec> read_machine_sensors(TomlReader& drive, const Units& units);

/// A [drive]. Its owner may have read keys of its own before.
DriveSpec read_drive_table(TomlReader& table, const Units& units);

}  // namespace jounce::spec_detail
