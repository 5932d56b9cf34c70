// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/io/gcode.hpp"
#include "jounce/io/points.hpp"

namespace jounce {

/// Units of the records, where their header gives none.
struct RecordUnits {
  std::string velocity;      ///< "pulse/s"
  std::string acceleration;  ///< "pulse/s^2"
};

/// The records of LS_3AxisMoveSequence and LS_4AxisMoveSequence (PMC600 manual 8.1.6, Tables 4.13 and 8.7), one a
/// row, as commands of a path:
///
///     LineNum; DataType; X_EndPos; Y_EndPos; Z_EndPos; Vel; Acc; Aux_Pos0; Aux_Pos1
///     1;       1;        1000;     1000;     0;        1000; 2000; 0;     0
///     2;       2;        2000;     0;        0;        1000; 2000; 1700;  700
///
/// **Columns**, in either case: `X_EndPos` and one such column for each axis of the machine, by its name: absolute
/// positions. `DataType`: 1 line (without the column, too), 2 arc through Aux_Pos0 and Aux_Pos1 in the plane of the
/// first two axes; all other axes run in proportion to its angle. `Vel` and `Acc`, without the columns those of the
/// machine's settings. `LineNum`: a whole number. Each command has the line of its row.
///
/// **Throws** InputError with document, line and column (as its key): an unknown or missing column, another
/// DataType, a number out of range, an arc that does not fit.
Program record_program(const Points& records, const GcodeMachine& machine,
                       const RecordUnits& units);

}  // namespace jounce
