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

/// Watches a run step by step and keeps what the result reports: peaks, swings, energy, samples.
class Observer {
 public:
  /// Samples are spaced equally over the duration; origin is the signal's time at the solver's
  /// zero.
  Observer(const DriveModel& model, const DriveOptions& options, double origin, double duration);

  /// Called after each step, with the reference of that step. Reads the solver's dense output.
  void step(const OdeSolver& solver, const SignalPiece& reference);

  /// Called at the end of the reference: from here on, residual and swings are watched.
  void settle(double end) { settling_ = true, end_ = end; }

  /// Swings slower than `least_speed` (rad/s) or than 1 % of the fastest do not count.
  void finish(double least_speed, DriveResult& result);

 private:
  struct Point {
    double time;
    double torque;
    double motor;  ///< rad, relative to the reference; so is the load
    double load;
    double load_speed;
    double velocity;  ///< rad/s, of the motor
    double swing;     ///< rad
    double reference;
  };
  using Points = std::array<Point, 3>;  ///< beginning, middle and end of a step

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
  std::optional<Point> last_ = {};    ///< state at the end of the last step,
  long restarts_ = -1;                ///< unless the solver restarted there
  bool beyond_ = false;               ///< the limit of the following error, at the last point
  std::optional<double> inside_ = 0;  ///< time since when; none: outside of the band
  Swings swings_;
};

}  // namespace jounce::validate_detail
