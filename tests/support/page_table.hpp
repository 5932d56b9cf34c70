// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>

namespace jounce::test {

/// Returns the table of the page docs/`page` that begins with the line `heading`; "" if there is
/// none.
inline std::string table_in(const std::string& page, const std::string& heading) {
  std::ifstream file(std::string(JOUNCE_SOURCE_DIR) + "/docs/" + page);
  std::string table;
  for (std::string line; std::getline(file, line);)
    if (table.empty() ? line == heading : line.starts_with('|'))
      table += line + "\n";
    else if (!table.empty())
      break;
  return table;
}

}  // namespace jounce::test
