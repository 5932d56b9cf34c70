// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "jounce/profiles/curve/segment.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "validate/src/linear/ladder.hpp"

namespace jounce::validate_detail {

/// The bounds of the magnitude of an output.
struct Magnitude {
  double least = 0;  ///< lower bound; 0 if the output may cross zero
  double most = 0;   ///< upper bound
};

/// For an output from its values at both ends and a bound of its second derivative: (1) of enclosure.cpp.
inline Magnitude bounds_of(double begin, double end, double length, double bend) {
  const double slack = length * length / 8 * bend;
  const double near = std::min(std::abs(begin), std::abs(end));
  return {(begin < 0) != (end < 0) ? 0 : std::max(0.0, near - slack),
          std::max(std::abs(begin), std::abs(end)) + slack};
}

/// An interval of the trajectory of a linear system.
struct TrajectorySpan {
  double time = 0;        ///< time of its start, s
  double length = 0;      ///< length, s
  Eigen::VectorXd z;      ///< state at its start
  Eigen::VectorXd begin;  ///< outputs at its start
  Eigen::VectorXd end;    ///< outputs at its end
  Eigen::VectorXd bend;   ///< bound of the second derivative of each output in between

  [[nodiscard]] Magnitude bounds(Eigen::Index row) const {
    return bounds_of(begin(row), end(row), length, bend(row));
  }
};

/// Proven bounds of the outputs of a ladder's system between two instants: by the second derivative
/// and, over a short time, by a polynomial that is exact to rounding. Derivation: enclosure.cpp.
class Enclosure {
 public:
  /// The ladder must outlive the object.
  explicit Enclosure(Ladder& ladder);

  /// Greatest length of an interval, s.
  [[nodiscard]] double longest() const { return longest_; }
  /// Index of the rung of that length.
  [[nodiscard]] std::size_t level() const { return level_; }

  /// Writes bounds of the second derivatives over `longest()` from z on to `found`, one for each
  /// output.
  void bend(const Eigen::VectorXd& z, double* found);

  /// Divides an interval in the order of time. A part for which open(part) is false is passed to
  /// done(part). A part that is short enough for a polynomial is passed to leaf(part).
  template <class Open, class Done, class Leaf>
  void search(const TrajectorySpan& s, const Open& open, const Done& done, const Leaf& leaf) {
    if (!open(s)) return done(s);
    if (s.length <= ladder_->shortest() * (1 + profiles_detail::rounded_sum)) return leaf(s);
    const auto [first, second] = halves(s);
    search(first, open, done, leaf);
    search(second, open, done, leaf);
  }

  /// Returns an output over an interval that search() passes to `leaf`, exact within 1e-12 of its
  /// terms.
  [[nodiscard]] Segment polynomial(const TrajectorySpan& s, Eigen::Index row) {
    return ladder_->polynomial(s.z, row, s.length);
  }

 private:
  struct Halves {
    TrajectorySpan first;
    TrajectorySpan second;
  };
  [[nodiscard]] Halves halves(const TrajectorySpan& s);

  Ladder* ladder_;
  std::size_t level_;
  double longest_;
  Eigen::MatrixXd twice_;   // M^2
  Eigen::MatrixXd reach_;   // G of (3)
  Eigen::VectorXd second_;  // M^2 z
};

}  // namespace jounce::validate_detail
