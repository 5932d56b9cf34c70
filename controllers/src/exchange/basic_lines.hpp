// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controllers/src/exchange/exchange_parts.hpp"

/// Programs with one command in a line, such as BASIC of Trio and DMC of Galil.
namespace jounce::controllers_detail {

/// Returns the commands: the lines and their parts at `;` and `:`, without comments (`'`, REM).
std::vector<Line> basic_lines(std::string_view text);

/// Returns the numbers in `NAME(1, 2, 3)` or, without parentheses, in `NAME 1,2,3`; none if the line
/// has another command. An empty value is 0. Fails for text that is not a finite number.
std::optional<std::vector<double>> arguments_of(const Line& line, std::string_view name,
                                                const Place& place);

/// True if a command of the text begins with this word, in upper case.
bool has_command(const std::string& text, std::string_view word);

}  // namespace jounce::controllers_detail
