// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/path/program.hpp"

#include "edit/src/editable.hpp"

namespace jounce::edit_detail {

/// Returns the end of each command.
std::vector<Point> ends_of(const Program& program);

/// Returns the difference between the end of a command and the numbers of its text: the position
/// from which a relative command counts. `row`: "command[2]". `from`: end of the previous command.
Point shift_of(const Editable& editable, const std::string& row, const Point& from,
               const Point& end, std::size_t axes);

}  // namespace jounce::edit_detail
