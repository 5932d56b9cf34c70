// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/executor_tables.hpp"

#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/design/detail/reference.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

ExecutorTables executor_tables(const Input& input) {
  const Units& units = input.table.units;
  if (std::holds_alternative<Cam>(*input.curve)) {
    // A cubic table represents a trapezoid and a straight line exactly.
    const Trajectory motion = master_of(input);
    const std::vector<double> knots(motion.breaks().begin(), motion.breaks().end());
    Sampled master = sample(motion, Interpolation::cubic_hermite, knots);
    return {input.table,
            TableFile{std::move(master.table), {"s", units.x}, input.table.provenance}};
  }
  if (units.x.empty())
    throw InputError("x_unit", "", "is missing: the table has no unit of time, such as s");
  return {TableFile{stretched(input.table.table, conversion(units.x, "s")),
                    {"s", units.position},
                    input.table.provenance},
          std::nullopt};
}

}  // namespace jounce
