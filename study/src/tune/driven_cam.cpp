// SPDX-License-Identifier: Apache-2.0
// A cam and its drive over time.
#include "study/src/tune/driven_cam.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

namespace jounce::study_detail {
namespace {

constexpr std::size_t moving = 500;         ///< steps along the cam
constexpr std::size_t most_settling = 500;  ///< steps of standstill after it
constexpr std::size_t closer = 8;           ///< refinement of the search for a peak, applied twice
constexpr double same_instant = 1e-6;       ///< share of a step

void make_linear(Friction& friction) {
  friction.coulomb = 0;
  friction.breakaway = 0;
}

/// The drive without the nonlinear parts that nonlinearity() lists.
Drive linear_twin(Drive drive) {
  make_linear(drive.motor.friction);
  for (Mass& mass : drive.train) {
    make_linear(mass.friction);
    mass.backlash = 0;
    mass.efficiency = 1;
    mass.gravity_torque = 0;
  }
  drive.controller.encoder_counts = 0;
  return drive;
}

Segment at_speed(Segment segment, double velocity) {
  segment.length /= velocity;
  return segment;
}

void require_one_run(const CamShapeProblem& problem) {
  const auto& shapes = problem.shapes;
  for (std::size_t i = 1; i < shapes.size(); ++i)
    if (shapes[i].segment != shapes[i - 1].segment + 1)
      throw InputError("segment[" + std::to_string(shapes[i].segment + 1) + "].free.shape",
                       static_cast<double>(shapes[i].pieces),
                       "against a drive, free segments must be adjacent: free the segments between "
                       "too, and hold them with a corridor");
}

}  // namespace

DrivenCam::DrivenCam(const CamShapeProblem& problem, const Against& against)
    : against_(against), twin_(linear_twin(against.drive)), linear_(!nonlinearity(against.drive)) {
  require_one_run(problem);
  const CamDesign made = design(problem.cam);
  for (std::size_t i = 0; i < made.origin.size(); ++i) {
    const Segment segment = at_speed(made.cam.segments()[i], against.velocity);
    if (made.origin[i] < problem.shapes.front().segment) before_.push_back(segment);
    if (made.origin[i] > problem.shapes.back().segment) after_.push_back(segment);
  }
  step_ = made.cam.length() / against.velocity / static_cast<double>(moving);
  settling_ = against.periodic
                  ? 0
                  : static_cast<std::size_t>(std::clamp(std::ceil(against.settle / step_), 1.0,
                                                        static_cast<double>(most_settling)));
}

Trajectory DrivenCam::over_time(const CamSpec& cam) const {
  const CamDesign made = design(cam);
  std::vector<Segment> segments;
  for (const Segment& segment : made.cam.segments())
    segments.push_back(at_speed(segment, against_.velocity));
  return Trajectory(std::move(segments));
}

std::vector<double> DrivenCam::even_times() const {
  std::vector<double> times(moving + settling_ + 1);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = step_ * static_cast<double>(i);
  return times;
}

std::vector<double> DrivenCam::times() const {
  std::vector<double> times = even_times();
  times.insert(times.end(), peaks_.begin(), peaks_.end());
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<double> DrivenCam::magnitudes(DriveFigure figure, const Trajectory& motion,
                                          const std::vector<double>& at) const {
  std::vector<double> all;
  for (const DriveSample& s : samples(motion, at))
    all.push_back(std::abs(figure == DriveFigure::torque            ? s.torque
                           : figure == DriveFigure::following_error ? s.following_error
                                                                    : s.load - s.reference));
  return all;
}

std::vector<double> DrivenCam::peaks_of(DriveFigure figure, const Trajectory& motion,
                                        double level) const {
  const std::size_t first = figure == DriveFigure::residual ? moving : 0;
  const double begin = step_ * static_cast<double>(first);
  std::vector<double> at;
  for (std::size_t i = 0; i <= closer * (moving + settling_ - first); ++i)
    at.push_back(begin + step_ / closer * static_cast<double>(i));
  at.back() = step_ * static_cast<double>(moving + settling_);
  std::vector<double> closely;  // around each peak, refined once more
  const std::vector<double> y = magnitudes(figure, motion, at);
  for (std::size_t i = 1; i + 1 < at.size(); ++i)
    if (y[i] > y[i - 1] && y[i] >= y[i + 1])
      for (std::size_t k = 0; k < 2 * closer; ++k)
        closely.push_back(at[i - 1] + step_ / (closer * closer) * static_cast<double>(k));
  std::vector<double> found;
  if (closely.empty()) return found;
  const std::vector<double> z = magnitudes(figure, motion, closely);
  for (std::size_t i = 1; i + 1 < closely.size(); ++i) {
    const double bend = z[i - 1] - 2 * z[i] + z[i + 1];
    if (z[i] <= z[i - 1] || z[i] < z[i + 1] || !(bend < 0)) continue;
    const double off = std::clamp((z[i - 1] - z[i + 1]) / (2 * bend), -1.0, 1.0);
    if (z[i] - (z[i - 1] - z[i + 1]) * off / 4 > level)
      found.push_back(closely[i] + off * step_ / (closer * closer));
  }
  return found;
}

std::size_t DrivenCam::add_peaks(DriveFigure figure, const CamSpec& cam, double level) {
  if (figure == DriveFigure::rms_torque || figure == DriveFigure::end_following_error) return 0;
  const std::vector<double> known = times();
  const std::size_t before = peaks_.size();
  for (const double t : peaks_of(figure, over_time(cam), level)) {
    const auto after = std::lower_bound(known.begin(), known.end(), t);
    const double near = same_instant * step_;
    if (after != known.end() && *after - t < near) continue;
    if (after != known.begin() && t - *std::prev(after) < near) continue;
    peaks_.push_back(t);
  }
  return peaks_.size() - before;
}

std::vector<DriveSample> DrivenCam::samples(const Trajectory& motion,
                                            const std::vector<double>& at) const {
  return against_.periodic ? exact_period(motion, twin_, at).samples
                           : exact_run(motion, twin_, at).samples;
}

std::vector<double> DrivenCam::weight_slopes(const CamSpec& cam) const {
  const auto& train = against_.drive.train;
  if (std::all_of(train.begin(), train.end(), [](const Mass& m) { return m.gravity_torque == 0; }))
    return {};
  const double turn = 2 * std::numbers::pi / against_.drive.position_per_rev;
  const Trajectory motion = over_time(cam);
  std::vector<double> slopes;
  for (const double t : times()) {
    const double angle = turn * motion.at(std::min(t, motion.end())).position;
    slopes.push_back(0);
    for (const Mass& m : train)
      slopes.back() += m.gravity_torque * m.gravity_ratio * turn *
                       std::cos(m.gravity_angle + m.gravity_ratio * angle);
  }
  return slopes;
}

std::vector<double> DrivenCam::list(DriveFigure figure, const std::vector<DriveSample>& samples,
                                    const std::vector<double>& slopes) const {
  std::vector<double> y;
  const std::vector<double> at = times();
  const std::vector<double> all = even_times();
  std::size_t i = 0;  // index of the next equally spaced instant
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const DriveSample& s = samples[k];
    const bool even = i < all.size() && at[k] == all[i];
    const double torque = s.torque + (slopes.empty() ? 0 : slopes[k] * s.reference);
    if (figure == DriveFigure::torque) y.push_back(torque);
    if (figure == DriveFigure::following_error) y.push_back(s.following_error);
    if (figure == DriveFigure::rms_torque && even && i <= moving) {
      // The mean of the squares is the trapezoidal rule: half of both ends, divided by one interval less.
      const double share = (i == 0 || i == moving ? 0.5 : 1.0) * (moving + 1.0) / moving;
      y.push_back(std::sqrt(share) * torque);
    }
    if (figure == DriveFigure::residual && at[k] >= all[moving]) y.push_back(s.load - s.reference);
    if (figure == DriveFigure::end_following_error && even && i == moving)
      y.push_back(s.following_error);
    if (even) ++i;
  }
  return y;
}

std::function<std::vector<double>(const Trajectory& shape)> DrivenCam::response(
    DriveFigure figure, const std::vector<double>& slopes) const {
  return [this, figure, slopes, at = times()](const Trajectory& shape) {
    std::vector<Segment> segments = before_;
    for (const Segment& segment : shape.segments())
      segments.push_back(at_speed(segment, against_.velocity));
    segments.insert(segments.end(), after_.begin(), after_.end());
    return list(figure, samples(Trajectory(std::move(segments)), at), slopes);
  };
}

DriveResult DrivenCam::run(const CamSpec& cam) const {
  return drive_through(over_time(cam), against_.drive,
                       {.settle = against_.settle, .periodic = against_.periodic});
}

DrivenCam::Lists DrivenCam::measured(const CamSpec& cam) const {
  const DriveResult run = drive_through(over_time(cam), against_.drive,
                                        {.settle = step_ * static_cast<double>(settling_),
                                         .samples = times().size(),
                                         .periodic = against_.periodic});
  Lists lists;
  if (run.integration.ok())
    for (const DriveFigure figure : all_drive_figures)
      lists[figure] = list(figure, run.samples, {});
  return lists;
}

DrivenCam::Lists DrivenCam::linear(const CamSpec& cam, const std::vector<double>& slopes) const {
  const std::vector<double> at = times();
  const std::vector<DriveSample> run = samples(over_time(cam), at);
  Lists lists;
  for (const DriveFigure figure : all_drive_figures) lists[figure] = list(figure, run, slopes);
  return lists;
}

double value_of(DriveFigure figure, const DriveResult& run) {
  switch (figure) {
    case DriveFigure::torque:
      return std::abs(run.torque.value);
    case DriveFigure::rms_torque:
      return run.rms_torque;
    case DriveFigure::residual:
      return std::abs(run.residual.value);
    case DriveFigure::following_error:
      return std::abs(run.following_error.value);
    case DriveFigure::end_following_error:
      return std::abs(run.end_following_error);
  }
  return 0;
}

}  // namespace jounce::study_detail
