// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

#include "validate/src/linear/ladder.hpp"
#include "validate/src/linear/linear_system.hpp"

namespace jounce::validate_detail {

/// The start of a path: the state before the reference's first step, to its own position and from this
/// velocity.
struct PathStart {
  Eigen::VectorXd state;
  double velocity = 0;
};

/// The trajectory of a linear system along a curve that holds after its end. The system and the curve must
/// outlive it.
class ExactPath {
 public:
  /// `step` > 0: the most frequent spacing of the outputs.
  ExactPath(const LinearSystem& system, const Trajectory& reference, double step, PathStart start);

  /// The reference as a whole.
  struct Whole {
    double square = 0;       ///< integral of the first output, squared
    Eigen::VectorXd output;  ///< at the end of the reference
    Eigen::VectorXd state;   ///< there, at the beginning of the standstill that follows
  };
  Whole whole();
  /// The same, and the outputs at ascending times, none before the reference's start, one column for each time;
  /// below them the position of the reference.
  Whole along(std::span<const double> times, Eigen::MatrixXd& found);

  // Step by step: begin(). Then for each segment enter(i), move state() with ladder(), and leave(); enter()
  // with the number of segments for the standstill after the last.

  void begin();
  /// Takes the system into segment i, with the steps of the reference.
  const Segment& enter(std::size_t i);
  /// The values of the reference at the end of the segment, from which the next one steps.
  void leave();
  /// True if the standstill was entered last.
  [[nodiscard]] bool rests() const { return segment_ == &standstill_; }
  [[nodiscard]] Ladder& ladder() { return *ladder_; }
  /// The system's state where the last segment ended, before any step that follows; after along() or whole().
  [[nodiscard]] const Eigen::VectorXd& reached() const { return reached_; }
  [[nodiscard]] Eigen::VectorXd& state() { return z_; }  ///< includes the part of the reference

 private:
  /// The columns of `found` for equally spaced times, from z_ on, the first at u of the segment that begins
  /// there.
  void read(std::span<const double> times, double begin, double u, double* found);
  Ladder& ladder_for(const Segment& f);
  [[nodiscard]] const Segment& segment(std::size_t i) const;

  const LinearSystem& system_;
  const Trajectory& reference_;
  double step_;
  PathStart start_;
  int degree_ = 2;
  Segment standstill_;
  std::deque<Ladder> ladders_;
  Ladder* ladder_ = nullptr;
  const Segment* segment_ = nullptr;
  Eigen::VectorXd z_;
  Eigen::VectorXd reached_;
  std::vector<double> ahead_;
  std::array<double, 2> before_{};  // position and velocity of the reference before the break
};

}  // namespace jounce::validate_detail
