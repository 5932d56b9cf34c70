// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "jounce/validate/identify.hpp"

#include "validate/src/identify/least_squares.hpp"

namespace jounce::validate_detail {

/// The end of a fit. Residuals are model minus recording, one quantity after the other.
struct Fitted {
  LeastSquares found;             ///< weighted with 1 / sigma; x: logarithms of value / start
  std::vector<double> values;     ///< values of the numbers
  std::vector<std::size_t> used;  ///< the recorded outputs
  Eigen::VectorXd before;         ///< residuals of the start, not weighted
  Eigen::VectorXd sigma;          ///< one for each output
  int iterations = 0;
  bool cancelled = false;
  std::string failure;  ///< failure of the last integration without a result

  [[nodiscard]] Eigen::Index samples() const {
    return before.size() / static_cast<Eigen::Index>(used.size());
  }
  /// Those of output used[b].
  [[nodiscard]] Eigen::VectorXd block(const Eigen::VectorXd& residuals, Eigen::Index b) const {
    return residuals.segment(b * samples(), samples());
  }
};

double rms(const Eigen::VectorXd& r);

Fitted fitted(const Recording& recording, const SignalView& reference, const IdentifySpec& spec,
              const IdentifyProgress& keep_going);

/// The report of a fit: intervals, notes, status and reason.
Identification told(const Recording& recording, const IdentifySpec& spec, const Fitted& fit);

}  // namespace jounce::validate_detail
