// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/design/input.hpp"

namespace jounce {

/// The tables that an executor needs to play an input. Their axis is the time in seconds; that of a cam's slave is its
/// master.
struct ExecutorTables {
  TableFile slave;
  std::optional<TableFile> master;  ///< for a cam: position of the master, in its unit
};

/// Throws InputError for a cam whose spec has no [master].
ExecutorTables executor_tables(const Input& input);

}  // namespace jounce
