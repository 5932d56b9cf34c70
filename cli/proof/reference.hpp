// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/design/reference.hpp"

#include "cli/common/input.hpp"

namespace jounce::cli {

/// The tables that an executor needs, in seconds: the slave's, and the master's for a cam.
struct Tables {
  TableFile slave;
  std::optional<TableFile> master;
};
Tables executor_tables(const Input& input);

}  // namespace jounce::cli
