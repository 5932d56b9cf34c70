// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/design/input.hpp"

namespace jounce {

/// The tables with which an executor plays an input. A table over time is in s. For a cam, the
/// table of the slave is over the master's position.
struct ExecutorTables {
  TableFile slave;  ///< position over time; for a cam: slave over master
  std::optional<TableFile> master =
      {};  ///< for a cam: position of the master over time, in its unit
};

/// Makes the tables. Throws InputError for a cam whose spec has no [master].
ExecutorTables executor_tables(const Input& input);

}  // namespace jounce
