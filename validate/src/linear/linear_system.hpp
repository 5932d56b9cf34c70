// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace jounce::validate_detail {

/// A linear drive along a reference r, in deviations from it:
///
///     x' = A x + B w,   y = C x + D w,   w = (1, r', r'')
///
/// The function that made the system determines the units; time is in seconds. At a step of the
/// reference by p in position and v in velocity, the axis itself does not move, and its deviation
/// becomes x - p * follows_position - v * follows_velocity.
struct LinearSystem {
  enum Input { one, velocity, acceleration, inputs };

  Eigen::MatrixXd a;
  Eigen::MatrixXd b;  ///< inputs columns
  Eigen::MatrixXd c;
  Eigen::MatrixXd d;  ///< inputs columns
  Eigen::VectorXd follows_position;
  Eigen::VectorXd follows_velocity;
  /// x in the units of the function that made the system is scale times x, entry by entry.
  Eigen::VectorXd scale;

  [[nodiscard]] Eigen::Index states() const { return a.rows(); }
  [[nodiscard]] Eigen::Index outputs() const { return c.rows(); }
};

/// Returns the same system with its states scaled by powers of two. The rows and columns of A are
/// then of about the same size (Parlett & Reinsch 1969). Without that, states in rad next to states
/// in rad/s and N m would cost the exponential many squarings. The outputs are unchanged, to the
/// last bit.
LinearSystem balanced(LinearSystem system);

/// Returns the greatest row sum of |A|, a bound of every rate of change.
double rate(const LinearSystem& system);

}  // namespace jounce::validate_detail
