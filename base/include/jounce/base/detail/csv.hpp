// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace jounce {

/// Returns the values of one line of CSV: the texts between its commas. Quotes have no special
/// meaning, because the files of Jounce do not need them.
std::vector<std::string_view> csv_cells(std::string_view line);

/// Returns a value as a finite number; nullopt for any other text.
std::optional<double> csv_number(std::string_view cell);

}  // namespace jounce
