// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "jounce/study/against.hpp"

/// A cam as a drive that follows it once sees it, of which one run of segments changes. The drive is looked at at
/// equally spaced instants, and at the peaks that add_peaks() found between them.
namespace jounce::detail {

class DrivenCam {
 public:
  /// The free segments of the problem must be one run within the cam.
  DrivenCam(const CamShapeProblem& problem, const Against& against);

  /// What a figure is made of, at the instants that are looked at.
  using Lists = std::map<DriveFigure, std::vector<double>>;

  /// Adds an instant at each peak of a figure along a cam that is above a level and lies between the instants that are
  /// looked at; how many. For a linear drive.
  std::size_t add_peaks(DriveFigure figure, const CamSpec& cam, double level);

  /// Looks at the equally spaced instants alone again.
  void forget_peaks() { peaks_.clear(); }

  /// How the torque that an arm's weight asks for grows with the reference, N m/u, at these instants
  /// along a cam; none without an arm.
  [[nodiscard]] std::vector<double> weight_slopes(const CamSpec& cam) const;

  /// For the linear drive, with a shape over the master in place of the run; to its torque slope times
  /// reference is added.
  [[nodiscard]] std::function<std::vector<double>(const Trajectory& shape)> response(
      DriveFigure figure, const std::vector<double>& slopes) const;

  /// For the drive as it is, integrated, along a whole cam; `result` is that run, with its own standstill.
  [[nodiscard]] DriveResult run(const CamSpec& cam) const;
  [[nodiscard]] Lists measured(const CamSpec& cam) const;
  [[nodiscard]] Lists linear(const CamSpec& cam, const std::vector<double>& slopes) const;

  /// True if the linear drive is the drive, as far as its torque keeps its limits.
  [[nodiscard]] bool is_linear() const { return linear_; }

 private:
  [[nodiscard]] Trajectory over_time(const CamSpec& cam) const;
  /// Where a figure's peaks are between the instants, s: of magnitudes above the level.
  [[nodiscard]] std::vector<double> peaks_of(DriveFigure figure, const Trajectory& motion,
                                             double level) const;
  /// The magnitudes of a figure whose peak counts, along a motion.
  [[nodiscard]] std::vector<double> magnitudes(DriveFigure figure, const Trajectory& motion,
                                               const std::vector<double>& at) const;
  /// The instants that are looked at, ascending.
  [[nodiscard]] std::vector<double> times() const;
  [[nodiscard]] std::vector<double> even_times() const;
  [[nodiscard]] std::vector<DriveSample> samples(const Trajectory& motion,
                                                 const std::vector<double>& at) const;
  [[nodiscard]] std::vector<double> list(DriveFigure figure,
                                         const std::vector<DriveSample>& samples,
                                         const std::vector<double>& slopes) const;

  Against against_;
  Drive twin_;  ///< linear
  bool linear_ = true;
  std::vector<Segment> before_, after_;  ///< after of the cam, over time
  double step_ = 0;                      ///< s
  std::size_t settling_ = 0;             ///< steps
  std::vector<double> peaks_;            ///< instants beside the equally spaced ones, s
};

/// The number that a run has for a figure.
double value_of(DriveFigure figure, const DriveResult& run);

}  // namespace jounce::detail
