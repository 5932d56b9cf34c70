// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/io/table_file.hpp"
#include "jounce/pvt/pt.hpp"

namespace jounce {

/// A table as the segments of a controller that plays PT or follow tables, and as CSV that the kinds
/// "pt" and "follow" read (`points`):
///
///     Sampled table = reduced(move, target_of(*controller_table("googol_pt"), {"ms", "pulse"}));
///     write_file("pt.csv", points_text({table.table, {"ms", "pulse"}, {}}));
///
///     time [ms],position [pulse],type
///     16,0.6,normal
///
/// Numbers are relative to the first knot, which is not a point. Straight lines are `even`;
/// quadratic pieces (reduce.hpp) are `normal`, the first one over a master is `continue` if it
/// begins at a ratio.
///
/// Throws InputError for pieces that are neither, and over time for a table that begins at a velocity.
std::vector<PtPoint> points_of(const Table& table);
std::string points_text(const TableFile& file);

}  // namespace jounce
