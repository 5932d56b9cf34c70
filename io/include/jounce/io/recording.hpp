// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/validate/identify.hpp"

namespace jounce {

/// Reads a recorded run of a drive from a CSV file (see points.hpp), and converts it to s, N m and
/// `position`, the unit of the drive's position:
///
///     time [ms],command [deg],feedback [deg],current [A]
///     0,0,0.01,0.02
///
/// `time` and `command` are required, and at least one of these columns:
/// - `feedback`: position of the motor's encoder, in the unit of the command;
/// - `velocity`;
/// - `torque`; or, if this column is missing, `current`, which is multiplied by the torque constant
///   of the drive;
/// - `load`: position of an encoder at the last mass.
///
/// A tick log with feedback (`jounce replay --csv`) is a recording, too. Its position, velocity and
/// acceleration are the setpoints. The feedback of a tick is its position minus the following error of
/// the next tick, which has the response. Its torque is a share of the rated torque of the motor or,
/// without one, of its torque limit. The longest section of ticks in which the axis is enabled is read.
/// It must begin at standstill.
///
/// Other columns are ignored. A column without a unit has the unit of the drive's spec, or s, N m,
/// A. Throws InputError with file, line, column and rule for everything that points.hpp rejects,
/// for a missing column, for fewer than four rows, for a number of magnitude 1e100 or more, for
/// times that do not ascend, and for a current if the drive has no torque constant.
Recording read_recording(const std::string& path, const Drive& drive, const std::string& position);

}  // namespace jounce
