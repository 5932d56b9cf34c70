#pragma once

#include <optional>
#include <variant>

#include "jounce/cam/followed.hpp"
#include "jounce/validate/signal_view.hpp"

#include "input.hpp"

namespace jounce::cli {

/// The slave's motion over time in seconds: a trajectory as it is, a cam behind its master.
using Reference = std::variant<Trajectory, Followed>;

/// As the exact curve has it.
Reference exact_reference(const Input& input);

/// As the executor will interpolate it, from the table.
Reference table_reference(const Input& input);

/// The tables that an executor needs, in seconds: the slave's, and the master's for a cam.
struct Tables {
  TableFile slave;
  std::optional<TableFile> master;
};
Tables executor_tables(const Input& input);

SignalView view(const Reference& reference);
double duration(const Reference& reference);
Motion at(const Reference& reference, double t);

}  // namespace jounce::cli
