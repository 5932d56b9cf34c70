// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "validate/src/exact/enclosure.hpp"
#include "validate/src/exact/exact_path.hpp"

namespace jounce::detail {

/// Steps one behind another within a segment, with what the outputs are and may be in each.
struct Steps {
  std::vector<double> time;     ///< time of the ends, one more than steps
  Eigen::MatrixXd z;            ///< states there, one column an end
  Eigen::MatrixXd y;            ///< outputs there
  Eigen::MatrixXd bend;         ///< bounds of their second derivatives, one column a step
  std::vector<double> squared;  ///< integral of the squared torque over each step
  std::vector<double> work;     ///< the same of the motor's power
  Eigen::VectorXd rounding;     ///< rounding of the outputs: what is less is none

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(squared.size()); }
  [[nodiscard]] double begin(Eigen::Index i) const { return time[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double length(Eigen::Index i) const { return begin(i + 1) - begin(i); }
  [[nodiscard]] Bounds bounds(Eigen::Index i, Eigen::Index row) const {
    return bounds_of(y(row, i), y(row, i + 1), length(i), bend(row, i));
  }
  [[nodiscard]] Stretch stretch(Eigen::Index i) const {
    return {begin(i), length(i), z.col(i), y.col(i), y.col(i + 1), bend.col(i)};
  }
};

/// Goes along a reference of a drive (a system with the rows of DriveRow) in steps.
class ExactSteps {
 public:
  /// The path must outlive it, and nobody else move it.
  explicit ExactSteps(ExactPath& path) : path_(&path) {}

  /// Into segment i, which begins at `begin`; their number: the standstill.
  void enter(std::size_t i, double begin);
  /// The next steps up to `to` or to where the block is full; nothing if it is there already.
  const Steps* next(double to);
  void leave() { path_->leave(); }

  /// For the segment that was entered.
  [[nodiscard]] Enclosure& enclosure() { return *enclosure_; }

 private:
  void add(double length);

  ExactPath* path_;
  const Segment* segment_ = nullptr;
  Enclosure* enclosure_ = nullptr;
  /// Over a whole step: what is done thousands of times is looked up once.
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

}  // namespace jounce::detail
