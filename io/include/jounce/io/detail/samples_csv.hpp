// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/io/table_file.hpp"

namespace jounce {

/// Returns samples of a table as CSV, for other programs to plot and compare. The first column
/// (time or master position) begins at the start of the table, and increases by `step` (> 0, in its
/// unit) from row to row, such as by the cycle of a controller. The last row is the end of the
/// table, even if it is not a whole number of steps from the start. The first line has the names
/// and units: `master [deg],position [mm],geo_velocity [mm/deg],geo_acceleration [mm/deg^2]`. The
/// text is not a table file: it has no head and no hash. Numbers have the shortest form that reads
/// back exactly. Throws InputError for a missing unit, a step that is not positive, or more than
/// 1e8 rows.
std::string samples_csv(const TableFile& file, double step);
/// Like samples_csv() above, for a step as text with a unit of the first column, such as "1 ms". An
/// InputError for the step has the key "every".
std::string samples_csv(const TableFile& file, const std::string& step);

}  // namespace jounce
