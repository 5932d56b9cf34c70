// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "validate/src/exact/enclosure.hpp"
#include "validate/src/exact/exact_path.hpp"

namespace jounce::validate_detail {

/// Successive steps within a segment, with the outputs and their bounds in each.
struct Steps {
  std::vector<double> time;     ///< time of the ends, one more than steps
  Eigen::MatrixXd z;            ///< states there, one column an end
  Eigen::MatrixXd y;            ///< states at the ends, one column each
  Eigen::MatrixXd bend;         ///< outputs at the ends
  std::vector<double> squared;  ///< bounds of their second derivatives, one column for each step
  std::vector<double> work;     ///< the same of the motor's power
  Eigen::VectorXd rounding;     ///< the same for the motor's power

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(squared.size()); }
  [[nodiscard]] double begin(Eigen::Index i) const { return time[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double length(Eigen::Index i) const { return begin(i + 1) - begin(i); }
  [[nodiscard]] Magnitude bounds(Eigen::Index i, Eigen::Index row) const {
    return bounds_of(y(row, i), y(row, i + 1), length(i), bend(row, i));
  }
  [[nodiscard]] TrajectorySpan span(Eigen::Index i) const {
    return {begin(i), length(i), z.col(i), y.col(i), y.col(i + 1), bend.col(i)};
  }
};

/// Follows a reference of a drive (a system with the rows of DriveRow) in steps.
class ExactSteps {
 public:
  /// The path must outlive it, and no other code may move it.
  explicit ExactSteps(ExactPath& path) : path_(&path) {}

  /// Into segment i, which begins at `begin`; their number: the standstill.
  void enter(std::size_t i, double begin);
  /// The next steps up to `to`, or until the block is full; none if `to` is reached.
  const Steps* next(double to);
  void leave() { path_->leave(); }

  /// Values of the present segment.
  [[nodiscard]] Enclosure& enclosure() { return *enclosure_; }

 private:
  void add(double length);

  ExactPath* path_;
  const Segment* segment_ = nullptr;
  Enclosure* enclosure_ = nullptr;
  /// Matrices over a whole step, computed once because they are used thousands of times.
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
