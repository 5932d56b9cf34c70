// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "jounce/validate/drive.hpp"

#include "validate/src/drive/drive_model.hpp"
#include "validate/src/drive/heat.hpp"
#include "validate/src/drive/swings.hpp"
#include "validate/src/witness/piece.hpp"
#include "validate/src/witness/solver.hpp"

namespace jounce::validate_detail {

/// Watches a run step by step and collects what its result contains: peaks, swings, energy,
/// samples.
class Observer {
 public:
  /// `origin`: time of the signal at time 0 of the solver. `duration`: the samples are equally
  /// spaced over it, s.
  Observer(const DriveModel& model, const DriveOptions& options, double origin, double duration);

  /// Call it after each step, with the reference of that step. It reads the dense output of the
  /// solver.
  void step(const OdeSolver& solver, const SignalPiece& reference);

  /// Call it at the end of the reference: from then on, residual and swings are watched.
  void settle(double end) { settling_ = true, end_ = end; }

  /// Sets the figures of the result. Swings slower than `least_speed` (rad/s), or than 1 % of the
  /// fastest, do not count.
  void finish(double least_speed, DriveResult& result);

 private:
  /// The state at one instant, in rad, rad/s and N m.
  struct Point {
    double time;
    double torque;
    double motor;  ///< angle of the motor relative to the reference
    double load;   ///< angle of the load relative to the reference
    double load_speed;
    double velocity;  ///< speed of the motor
    double swing;     ///< angle of the pendulum relative to the load
    double reference;
  };
  using Points = std::array<Point, 3>;  ///< start, middle and end of a step

  [[nodiscard]] Point point(const double* y, const SignalPiece& reference, double t) const;
  [[nodiscard]] Point between(const OdeSolver& solver, const SignalPiece& reference, double t);
  void swing(const Point& a, const Point& b);
  template <class Outside>
  [[nodiscard]] double crossing(const OdeSolver& solver, const SignalPiece& reference, double out,
                                double in, Outside outside);
  void beyond(const OdeSolver& solver, const SignalPiece& reference, const Points& p);
  void settling(const OdeSolver& solver, const SignalPiece& reference, const Points& p);
  void power(const Points& p, double done);
  void sample(const OdeSolver& solver, const SignalPiece& reference);

  const DriveModel& model_;
  const DriveOptions& options_;
  double origin_;
  Heat heat_;
  double spacing_;
  std::vector<double> scratch_;
  bool settling_ = false;
  double end_ = 0;
  DriveResult found_;
  double torque_squared_ = 0;  ///< integrals up to the last step
  double work_ = 0;
  /// State at the end of the last step; nullopt: none, or the solver restarted there.
  std::optional<Point> last_ = {};
  long restarts_ = -1;   ///< restarts of the solver up to then
  bool beyond_ = false;  ///< true if the last point exceeds the limit of the following error
  /// Time since which the load is in the settling band; nullopt: it is outside.
  std::optional<double> inside_ = 0;
  Swings swings_;
};

}  // namespace jounce::validate_detail
