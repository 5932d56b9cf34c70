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

/// The start of a path, before the first step of the reference. The reference steps from this
/// velocity to its own, and to its own position.
struct PathStart {
  Eigen::VectorXd state;  ///< state of the system
  double velocity = 0;    ///< velocity of the reference before the step
};

/// The trajectory of a linear system along a curve, which holds after its end. Both must outlive
/// the object.
class ExactPath {
 public:
  /// `step` > 0: the most frequent time between two outputs, s.
  ExactPath(const LinearSystem& system, const Trajectory& reference, double step, PathStart start);

  /// Result for the whole reference.
  struct Whole {
    double square = 0;       ///< integral of the square of the first output
    Eigen::VectorXd output;  ///< outputs at the end of the reference
    Eigen::VectorXd state;   ///< state at the start of the standstill that follows
  };
  /// Computes the whole reference.
  Whole whole();
  /// Computes the same, and the outputs at ascending times, none before the start of the reference.
  /// `found` gets one column for each time: the outputs, then the position of the reference.
  Whole along(std::span<const double> times, Eigen::MatrixXd& found);

  // Step by step: call begin(). Then, for each segment i, call enter(i), move state() with
  // ladder(), and call leave(). enter() with the number of segments enters the standstill after the
  // last one.

  void begin();
  /// Enters segment i, with the steps of the reference.
  const Segment& enter(std::size_t i);
  /// Stores the values of the reference at the end of the segment, from which the next one steps.
  void leave();
  /// True if the standstill was entered last.
  [[nodiscard]] bool rests() const { return segment_ == &standstill_; }
  [[nodiscard]] Ladder& ladder() { return *ladder_; }
  /// State of the system at the end of the last segment, before the step after it. Only after
  /// along() or whole().
  [[nodiscard]] const Eigen::VectorXd& reached() const { return reached_; }
  [[nodiscard]] Eigen::VectorXd& state() { return z_; }  ///< includes the part of the reference

 private:
  /// Writes the columns of `found` for equally spaced times, from z_ on. The first one is at u of
  /// the segment.
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
