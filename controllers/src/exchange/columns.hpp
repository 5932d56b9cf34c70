// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "controllers/src/exchange/exchange_parts.hpp"

/// Text files with one line for each knot.
namespace jounce::controllers_detail {

/// Returns the values of a line, separated by semicolons, white space or commas.
std::vector<std::string_view> column_cells(std::string_view line);

/// Returns the cells of the first line that is not a comment, if it can be a knot or a header;
/// otherwise none.
std::vector<std::string_view> first_cells(std::string_view text);

/// Reads knots of `columns` values: 2 (X Y) or 4 (X Y V A). `counted`: true if the first line
/// contains the number of knots.
std::vector<Exchanged> read_columns(const std::string& text, const Place& place,
                                    std::size_t columns, bool counted = false);

/// Returns a line for each knot, X and Y, or X Y V A for a quintic table, then `end`.
std::string rows_text(const TableFile& file, char separator, const std::string& end);

}  // namespace jounce::controllers_detail
