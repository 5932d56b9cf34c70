// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/io/table_file.hpp"

namespace jounce {

/// Returns the knots of a table as a structured array of NumPy (npy.hpp): a row for each knot, with
/// the fields of the CSV, such as time, position, velocity and acceleration. The file contains no
/// units, rule, origin or hash.
std::string to_npy(const TableFile& file);

}  // namespace jounce
