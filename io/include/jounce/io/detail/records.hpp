// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/io/gcode.hpp"
#include "jounce/io/points.hpp"

namespace jounce {

/// Units of velocity and acceleration in records whose header has no units.
struct RecordUnits {
  std::string velocity = {};      ///< "pulse/s"
  std::string acceleration = {};  ///< "pulse/s^2"
};

/// Reads the records of LS_3AxisMoveSequence and LS_4AxisMoveSequence (PMC600 manual 8.1.6, tables
/// 4.13 and 8.7) as the commands of a path. The input has one record in each row:
///
///     LineNum; DataType; X_EndPos; Y_EndPos; Z_EndPos; Vel; Acc; Aux_Pos0; Aux_Pos1
///     1;       1;        1000;     1000;     0;        1000; 2000; 0;     0
///     2;       2;        2000;     0;        0;        1000; 2000; 1700;  700
///
/// **Columns**, in upper or lower case:
/// - `X_EndPos`, and a column of this form for each other axis of the machine: absolute positions,
///   to which a rotary axis takes the shorter way;
/// - `DataType`: 1: line (also if the column is missing); 2: arc through Aux_Pos0 and Aux_Pos1 in
///   the plane of the first two axes, while all other axes move in proportion to its angle;
/// - `Vel` and `Acc`: > 0; `Acc` is also the deceleration; if the columns are missing, the values
///   in the machine's settings;
/// - `LineNum`: a whole number >= 0; not used.
///
/// The source line of each command is the line of its row in the document, not LineNum.
///
/// **Errors**: throws InputError with the document, the line, and as key the name of the column,
/// for an unknown or missing column, another DataType, a number out of range, or an arc that does
/// not fit.
Program record_program(const Points& records, const GcodeMachine& machine,
                       const RecordUnits& units);

}  // namespace jounce
