// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <stdexcept>
#include <vector>

#include <nlopt.hpp>

namespace jounce::optimizer {

/// Runs an NLopt solver from x, which it leaves where it ended. How it ended is not told: its codes prove nothing
/// either way, and the caller looks at the point itself. What a callback threw, and kept from NLopt in
/// `trouble`, is thrown on.
inline void optimize_forgiving(nlopt::opt& solver, std::vector<double>& x,
                               const std::exception_ptr& trouble) {
  double least = 0;
  try {
    solver.optimize(x, least);
  } catch (const nlopt::roundoff_limited&) {  // often at the solution
  } catch (const nlopt::forced_stop&) {       // ours
  } catch (const std::runtime_error&) {       // "nlopt failure": the point may still be good
  }
  if (trouble) std::rethrow_exception(trouble);
}

}  // namespace jounce::optimizer
