#pragma once

#include <optional>

#include "jounce/study/reference.hpp"

#include "input.hpp"

namespace jounce::cli {

/// The tables that an executor needs, in seconds: the slave's, and the master's for a cam.
struct Tables {
  TableFile slave;
  std::optional<TableFile> master;
};
Tables executor_tables(const Input& input);

}  // namespace jounce::cli
