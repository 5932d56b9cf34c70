// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace jounce {

/// The values of a line of CSV, between its commas. There is no quoting: the files of Jounce need
/// none.
std::vector<std::string_view> csv_cells(std::string_view line);

/// A value as a finite number; nothing if it is anything else.
std::optional<double> csv_number(std::string_view cell);

}  // namespace jounce
