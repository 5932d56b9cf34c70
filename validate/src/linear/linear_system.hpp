// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace jounce::validate_detail {

/// A linear drive along a reference r, in deviations from it:
///
///     x' = A x + B w,   y = C x + D w,   w = (1, r', r'')
///
/// The units are those of the maker, with time in seconds. Where the reference steps by p in position and v in
/// velocity, x does not move in space, so the deviation becomes x - p * follows_position - v *
/// follows_velocity.
struct LinearSystem {
  enum Input { one, velocity, acceleration, inputs };

  Eigen::MatrixXd a;
  Eigen::MatrixXd b;  ///< inputs columns
  Eigen::MatrixXd c;
  Eigen::MatrixXd d;  ///< inputs columns
  Eigen::VectorXd follows_position;
  Eigen::VectorXd follows_velocity;
  Eigen::VectorXd scale;  ///< x in the maker's units is scale times x, entry by entry

  [[nodiscard]] Eigen::Index states() const { return a.rows(); }
  [[nodiscard]] Eigen::Index outputs() const { return c.rows(); }
};

/// The same system with its states scaled by powers of two so that rows and columns of A are of one
/// size (Parlett & Reinsch 1969): radians beside rad/s and N m would otherwise cost the exponential
/// many squarings. The outputs are unchanged, to the last bit.
LinearSystem balanced(LinearSystem system);

/// max row sum of |A|: a bound of every rate.
double rate(const LinearSystem& system);

}  // namespace jounce::validate_detail
