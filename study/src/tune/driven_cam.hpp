// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "study/src/tune/against.hpp"

/// A cam of which one run of segments changes, with a drive that follows it once. The drive is
/// evaluated at equally spaced instants, and at the peaks between them that add_peaks() has found.
namespace jounce::study_detail {

class DrivenCam {
 public:
  /// The free segments of the problem must be one run within the cam.
  DrivenCam(const CamShapeProblem& problem, const Against& against);

  /// The values of each figure at the instants.
  using Lists = std::map<DriveFigure, std::vector<double>>;

  /// Adds an instant at each peak of a figure along a cam, if the peak exceeds the level and is
  /// between the instants. Returns the number of new instants. Only for a linear drive.
  std::size_t add_peaks(DriveFigure figure, const CamSpec& cam, double level);

  /// Removes the instants at peaks; the equally spaced ones remain.
  void forget_peaks() { peaks_.clear(); }

  /// Returns the derivatives of the torque of an arm's weight with respect to the reference, N m/u,
  /// at the instants along a cam; empty without an arm.
  [[nodiscard]] std::vector<double> weight_slopes(const CamSpec& cam) const;

  /// Returns the response of the linear drive to a shape over the master that replaces the run. Its
  /// torque includes slope * reference.
  [[nodiscard]] std::function<std::vector<double>(const Trajectory& shape)> response(
      DriveFigure figure, const std::vector<double>& slopes) const;

  /// Runs the drive itself, by integration along a whole cam.
  [[nodiscard]] DriveResult run(const CamSpec& cam) const;
  /// The figures of the drive itself along a cam.
  [[nodiscard]] Lists measured(const CamSpec& cam) const;
  /// The figures of the linear drive along a cam.
  [[nodiscard]] Lists linear(const CamSpec& cam, const std::vector<double>& slopes) const;

  /// True if the linear drive is exact as long as its torque stays within its limits.
  [[nodiscard]] bool is_linear() const { return linear_; }

 private:
  [[nodiscard]] Trajectory over_time(const CamSpec& cam) const;
  /// The instants, s, at which the magnitude of a figure has a peak above the level, between the
  /// known instants.
  [[nodiscard]] std::vector<double> peaks_of(DriveFigure figure, const Trajectory& motion,
                                             double level) const;
  /// The magnitudes of a figure along a motion, at these times.
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
  Drive twin_;  ///< the drive without its nonlinear parts
  bool linear_ = true;
  std::vector<Segment> before_, after_;  ///< the cam before and after the run, over time
  double step_ = 0;                      ///< time between two equally spaced instants, s
  std::size_t settling_ = 0;             ///< number of steps of the standstill
  std::vector<double> peaks_;            ///< instants in addition to the equally spaced ones, s
};

/// Returns the value of a figure in a run.
double value_of(DriveFigure figure, const DriveResult& run);

}  // namespace jounce::study_detail
