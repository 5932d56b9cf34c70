// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "optimize/src/solvers/interior_point.hpp"

namespace jounce::optimize_detail {

/// Returns the constant of each form.
inline Eigen::VectorXd constants_of(const std::vector<Form>& forms) {
  Eigen::VectorXd c(static_cast<Eigen::Index>(forms.size()));
  for (std::size_t k = 0; k < forms.size(); ++k)
    c[static_cast<Eigen::Index>(k)] = forms[k].constant;
  return c;
}

}  // namespace jounce::optimize_detail
