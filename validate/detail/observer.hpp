#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "jounce/validate/detail/drive_model.hpp"
#include "jounce/validate/detail/piece.hpp"
#include "jounce/validate/detail/solver.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce::detail {

/// Watches a run step by step and keeps what the result reports: peaks, swings, samples.
class Observer {
 public:
  /// Samples are spaced equally over the duration; origin is the signal's time at the solver's
  /// zero.
  Observer(const DriveModel& model, double origin, double duration, std::size_t samples);

  /// After each step, with the reference it was made along. Reads the solver's dense output.
  void step(const Solver& solver, const Piece& reference);

  /// From here on the reference stands still: residual and swings are watched.
  void settle() { settling_ = true; }

  /// Half the number of zeros of the load's velocity per second while settling. Swings slower than
  /// `noise` (rad/s) or than 1 % of the fastest do not count.
  [[nodiscard]] double frequency(double noise) const;

  [[nodiscard]] const Peak& torque() const { return torque_; }
  [[nodiscard]] const Peak& following_error() const { return following_error_; }
  [[nodiscard]] const Peak& residual() const { return residual_; }
  [[nodiscard]] std::vector<DriveSample> take_samples() { return std::move(samples_); }

 private:
  struct Point {
    double time;
    double torque;
    double motor;  ///< rad, relative to the reference; so is the load
    double load;
    double load_speed;
    double reference;
  };
  /// A zero of the load's velocity, and the greatest speed since the one before.
  struct Zero {
    double time;
    double speed;
  };

  [[nodiscard]] Point point(const Solver& solver, const Piece& reference, double t) const;
  void swing(const Point& a, const Point& b);
  void sample(const Solver& solver, const Piece& reference);

  const DriveModel& model_;
  double origin_;
  double spacing_;
  std::size_t wanted_;
  bool settling_ = false;
  Peak torque_;
  Peak following_error_;
  Peak residual_;
  std::vector<DriveSample> samples_;
  std::vector<Zero> zeros_;
  double speed_ = 0;
};

}  // namespace jounce::detail
