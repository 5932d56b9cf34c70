// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "jounce/validate/identify.hpp"

#include "validate/src/identify/least_squares.hpp"
#include "validate/src/identify/setpoint_curve.hpp"

namespace jounce::validate_detail {

/// Result of fitted(). Residuals are model minus recording, one quantity after another.
struct Fitted {
  std::vector<std::string> keys =
      {};              ///< the fitted numbers: those of the spec, then controller_share
  LeastSquares found;  ///< the search, weighted with 1 / sigma; x: logarithms of value / start
  std::vector<double> values;     ///< their values
  std::vector<std::size_t> used;  ///< indices of the recorded outputs
  Eigen::VectorXd before;         ///< residuals at the start, not weighted
  Eigen::VectorXd sigma;          ///< standard deviation of each output
  /// Response to half the samples of the command, minus the response to all; empty: not known.
  Eigen::VectorXd interpolation;
  /// Response with the counts of the encoder minus the response without; empty: no counts, or not known.
  Eigen::VectorXd counts;
  bool sampled = false;  ///< the model has the sampled controller of the drive
  int iterations = 0;
  bool cancelled = false;
  std::string failure;  ///< reason of the last integration that failed

  /// Number of samples.
  [[nodiscard]] Eigen::Index samples() const {
    return before.size() / static_cast<Eigen::Index>(used.size());
  }
  /// Returns the residuals of output used[b].
  [[nodiscard]] Eigen::VectorXd block(const Eigen::VectorXd& residuals, Eigen::Index b) const {
    return residuals.segment(b * samples(), samples());
  }
};

double rms(const Eigen::VectorXd& r);

/// Key of the torque feed-forward. Its value in a fit refers to the inertia at the start.
inline constexpr const char* controller_share = "controller.torque_feed_forward";

/// Fits the numbers with these keys.
Fitted fitted(const Recording& recording, const Commanded& command, const IdentifySpec& spec,
              std::vector<std::string> keys, const IdentifyProgress& keep_going);

/// Returns the result of identify(): intervals, notes, status and reason.
Identification told(const Recording& recording, const IdentifySpec& spec, const Fitted& fit);

}  // namespace jounce::validate_detail
