// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "validate/src/exact/enclosure.hpp"
#include "validate/src/exact/exact_path.hpp"

namespace jounce::validate_detail {

/// Successive steps within a segment, with the outputs and their bounds.
struct Steps {
  std::vector<double> time;  ///< times of the ends of the steps: one more than steps
  Eigen::MatrixXd z;         ///< states at these times, one column each
  Eigen::MatrixXd y;         ///< outputs at these times, one column each
  /// Bounds of the second derivatives of the outputs, one column for each step.
  Eigen::MatrixXd bend;
  std::vector<double> squared;  ///< integral of the squared torque over each step
  std::vector<double> work;     ///< work of the motor over each step
  Eigen::VectorXd rounding;     ///< bound of the rounding error of each output

  /// Number of steps.
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(squared.size()); }
  /// Start of step i.
  [[nodiscard]] double begin(Eigen::Index i) const { return time[static_cast<std::size_t>(i)]; }
  /// Length of step i.
  [[nodiscard]] double length(Eigen::Index i) const { return begin(i + 1) - begin(i); }
  [[nodiscard]] Magnitude bounds(Eigen::Index i, Eigen::Index row) const {
    return bounds_of(y(row, i), y(row, i + 1), length(i), bend(row, i));
  }
  /// Step i as an interval.
  [[nodiscard]] TrajectorySpan span(Eigen::Index i) const {
    return {begin(i), length(i), z.col(i), y.col(i), y.col(i + 1), bend.col(i)};
  }
};

/// Follows a reference of a drive (a system with the rows of DriveRow) in steps.
class ExactSteps {
 public:
  /// The path must outlive the object, and no other code may move it.
  explicit ExactSteps(ExactPath& path) : path_(&path) {}

  /// Enters segment i, which begins at `begin`; the number of segments: the standstill.
  void enter(std::size_t i, double begin);
  /// Returns the next steps up to `to`, at most a block of them; null if `to` is reached.
  const Steps* next(double to);
  /// See ExactPath::leave().
  void leave() { path_->leave(); }

  /// The bounds of the present segment.
  [[nodiscard]] Enclosure& enclosure() { return *enclosure_; }

 private:
  void add(double length);

  ExactPath* path_;
  const Segment* segment_ = nullptr;
  Enclosure* enclosure_ = nullptr;
  /// Matrices for a step of the greatest length. They are computed once, because they are used
  /// thousands of times.
  struct Whole {
    const Eigen::MatrixXd* step;
    const Eigen::MatrixXd* squared;
    const Eigen::MatrixXd* work;
  } whole_{};
  double begin_ = 0;
  double gone_ = 0;
  bool rests_ = false;
  std::map<const Ladder*, Enclosure> enclosures_ = {};
  Steps steps_ = {};
  Eigen::VectorXd next_ = {};
};

}  // namespace jounce::validate_detail
