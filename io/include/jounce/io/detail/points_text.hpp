// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/io/table_file.hpp"
#include "jounce/pvt/pt.hpp"

namespace jounce {

/// points_of() returns a table as the segments of a controller that plays PT or follow tables.
/// points_text() returns them as the CSV that the spec kinds "pt" and "follow" read (key `points`):
///
///     Sampled table = reduced(move, target_of(*controller_table("googol_pt"), {"ms", "pulse"}));
///     write_file("pt.csv", points_text({table.table, {"ms", "pulse"}, {}}));
///
/// The file:
///
///     time [ms],position [pulse],type
///     16,0.6,normal
///
/// Numbers are relative to the first knot, which is not a point. The pieces of a linear table
/// become points of the type `even`. In a cubic table, the velocity of each piece must be linear or
/// constant (reduce.hpp); the pieces become points of the type `normal`. If such a table over a
/// master begins at a nonzero ratio, its first point has the type `continued` (in the CSV:
/// continue).
///
/// Throws InputError for a quintic table, if the velocity within a piece is neither constant nor
/// linear, and for a cubic table over time that begins at a nonzero velocity.
std::vector<PtPoint> points_of(const Table& table);
/// Returns the points as CSV.
std::string points_text(const TableFile& file);

}  // namespace jounce
