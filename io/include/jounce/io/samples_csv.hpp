// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/io/table_file.hpp"

namespace jounce {

/// Returns samples of a table as CSV, for other programs to plot and compare. Rows follow at every
/// `step` > 0 of the first column, such as the cycle of a controller, from the start of the table
/// on. The last row is the end of the table, even if it is not a whole number of steps from the
/// start. The first line has the names and units: `master [deg],position [mm],geo_velocity
/// [mm/deg],geo_acceleration [mm/deg^2]`. The text is not a table file: it has no head and no hash.
/// Numbers have the shortest form that reads back exactly. Throws InputError for a missing unit, a
/// step that is not positive, or more than 1e8 rows.
std::string samples_csv(const TableFile& file, double step);
/// The same for a step as text, such as "1 ms", in a unit of the first column. Throws InputError (key "every").
std::string samples_csv(const TableFile& file, const std::string& step);

}  // namespace jounce
