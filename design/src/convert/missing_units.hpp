// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce::design_detail {

/// Returns the error of a file that names neither of its units. The examples are possible units.
inline InputError both_units_missing(const std::string& master, const std::string& position) {
  return {"master_unit", "",
          "is missing, and --position-unit, too: the file names no units. Give both, such as "
          "--master-unit " +
              master + " --position-unit " + position};
}

}  // namespace jounce::design_detail
