// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "study/src/tune/against.hpp"

/// A cam in which one run of segments changes, with a drive that follows it once. The drive is evaluated at
/// equally spaced instants, and at the peaks between them that add_peaks() found.
namespace jounce::study_detail {

class DrivenCam {
 public:
  /// The free segments of the problem must be one run within the cam.
  DrivenCam(const CamShapeProblem& problem, const Against& against);

  /// The values of each figure at the instants.
  using Lists = std::map<DriveFigure, std::vector<double>>;

  /// Adds an instant at each peak of a figure along a cam that is above a level and between the instants.
  /// Returns the number of new instants. For a linear drive.
  std::size_t add_peaks(DriveFigure figure, const CamSpec& cam, double level);

  /// Returns to the equally spaced instants alone.
  void forget_peaks() { peaks_.clear(); }

  /// The slopes of the torque of an arm's weight by the reference, N m/u, at the instants along a cam; none
  /// without an arm.
  [[nodiscard]] std::vector<double> weight_slopes(const CamSpec& cam) const;

  /// The response of the linear drive to a shape over the master in place of the run. Its torque includes slope
  /// times reference.
  [[nodiscard]] std::function<std::vector<double>(const Trajectory& shape)> response(
      DriveFigure figure, const std::vector<double>& slopes) const;

  /// The response of the drive itself, by integration along a whole cam.
  [[nodiscard]] DriveResult run(const CamSpec& cam) const;
  [[nodiscard]] Lists measured(const CamSpec& cam) const;
  [[nodiscard]] Lists linear(const CamSpec& cam, const std::vector<double>& slopes) const;

  /// True if the linear drive is exact as long as its torque keeps its limits.
  [[nodiscard]] bool is_linear() const { return linear_; }

 private:
  [[nodiscard]] Trajectory over_time(const CamSpec& cam) const;
  /// The instants, in s, of the peaks of a figure's magnitude above the level, between the known instants.
  [[nodiscard]] std::vector<double> peaks_of(DriveFigure figure, const Trajectory& motion,
                                             double level) const;
  /// The magnitudes of a figure with a peak, along a motion.
  [[nodiscard]] std::vector<double> magnitudes(DriveFigure figure, const Trajectory& motion,
                                               const std::vector<double>& at) const;
  /// The instants, ascending.
  [[nodiscard]] std::vector<double> times() const;
  [[nodiscard]] std::vector<double> even_times() const;
  [[nodiscard]] std::vector<DriveSample> samples(const Trajectory& motion,
                                                 const std::vector<double>& at) const;
  [[nodiscard]] std::vector<double> list(DriveFigure figure,
                                         const std::vector<DriveSample>& samples,
                                         const std::vector<double>& slopes) const;

  Against against_;
  Drive twin_;  ///< the linear drive
  bool linear_ = true;
  std::vector<Segment> before_, after_;  ///< after of the cam, over time
  double step_ = 0;                      ///< s
  std::size_t settling_ = 0;             ///< steps
  std::vector<double> peaks_;            ///< instants in addition to the equally spaced ones, s
};

/// The value of a figure in a run.
double value_of(DriveFigure figure, const DriveResult& run);

}  // namespace jounce::study_detail
