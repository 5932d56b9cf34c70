// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/io/table_file.hpp"

namespace jounce {

/// Samples of a table in the cycle of a controller: a line of names with units, `master
/// [deg],position [mm],geo_velocity [mm/deg],geo_acceleration [mm/deg^2]`, and a row every `step` >
/// 0 of the table's axis, from its start to at most its end. For other programs to plot and
/// compare: it is not a table (no head, no hash). Doubles in their shortest form that reads back
/// the same. Throws InputError for a unit that is missing, a step that is not positive, or more
/// than 1e8 rows.
std::string samples_csv(const TableFile& file, double step);

}  // namespace jounce
