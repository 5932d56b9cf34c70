// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/linear_drive.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "validate/src/drive/dense.hpp"
#include "validate/src/drive/drive_system.hpp"
#include "validate/src/exact/exact_path.hpp"
#include "validate/src/linear/periodic.hpp"
#include "validate/src/linear/sampled_drive.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

using Eigen::Index;
using validate_detail::DriveRow;
using validate_detail::ExactPath;
using validate_detail::LinearSystem;

/// Reciprocal condition of eigenvectors that are nearly parallel.
constexpr double parallel_vectors = 1e-6;

void require_linear(const Drive& drive) {
  require_valid(drive);
  if (const auto key = nonlinearity(drive))
    throw InputError(*key, "not 0", "makes the drive nonlinear, without an exact solution");
}

void require_times(std::span<const double> times, double start) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(times[i] >= (i == 0 ? start : times[i - 1])) || !std::isfinite(times[i]))
      throw InputError("times[" + std::to_string(i + 1) + "]", times[i],
                       i == 0 ? "must not be before the start of the reference, " + number(start)
                              : "must not be less than the time before, " + number(times[i - 1]));
  }
}

/// The spacing of equally spaced times, otherwise their mean.
double spacing(std::span<const double> times, double otherwise) {
  const double length = times.size() > 1 ? times.back() - times.front() : 0;
  return length > 0 ? length / static_cast<double>(times.size() - 1) : otherwise;
}

double radians_per_unit(const Drive& drive) {
  return 2 * std::numbers::pi / drive.position_per_rev;
}

/// Converts a column of ExactPath::along().
DriveSample sample(double t, double unit, const double* y) {
  const double r = y[validate_detail::drive_rows];
  return {t,
          r,
          r + unit * y[validate_detail::motor_row],
          r + unit * y[validate_detail::load_row],
          y[validate_detail::torque_row],
          -unit * y[validate_detail::motor_row],
          y[validate_detail::velocity_row]};
}

ExactRun continuous_run(const Trajectory& reference, const Drive& drive,
                        std::span<const double> times, bool periodic = false) {
  const LinearSystem system = balanced(validate_detail::drive_system(drive));
  ExactPath path(system, reference, spacing(times, reference.length()),
                 validate_detail::path_start(system, reference, drive, periodic));
  ExactRun run;
  Eigen::MatrixXd outputs;
  const ExactPath::Whole whole = path.along(times, outputs);
  run.samples.reserve(times.size());
  const double unit = 1 / radians_per_unit(drive);
  for (std::size_t i = 0; i < times.size(); ++i)
    run.samples.push_back(sample(times[i], unit, outputs.col(static_cast<Index>(i)).data()));
  run.rms_torque = std::sqrt(std::max(0.0, whole.square) / reference.length());
  run.end_following_error = -whole.output(validate_detail::motor_row) * unit;
  return run;
}

// ---- modes --------------------------------------------------------------------------------------

DriveMode mode_of(std::complex<double> eigenvalue) {
  DriveMode mode;
  mode.rate = -eigenvalue.real();
  mode.frequency = std::abs(eigenvalue.imag()) / (2 * std::numbers::pi);
  mode.damping = std::abs(eigenvalue) > 0 ? mode.rate / std::abs(eigenvalue) : 0;
  return mode;
}

/// x(t) = sum of v_k (V^-1 x)_k exp(l_k t): a pair of conjugates oscillates with twice the amplitude of one.
std::vector<DriveMode> modes_of(const LinearSystem& system, const Eigen::VectorXd& state,
                                double unit) {
  const auto [values, vectors] = validate_detail::eigenpairs(system.a);
  const auto [share, rcond] =
      validate_detail::solve_with_condition(vectors, state.cast<std::complex<double>>());
  // Nearly parallel vectors: the rest of each is a difference of large numbers.
  const bool apart = rcond > parallel_vectors;
  std::vector<DriveMode> found;
  for (Index k = 0; k < values.size(); ++k) {
    if (values(k).imag() < 0) continue;
    DriveMode mode = mode_of(values(k));
    const std::complex<double> swing =
        share(k) * (system.c.row(validate_detail::load_row) * vectors.col(k)).value();
    mode.residual = apart ? unit * std::abs(swing) * (values(k).imag() > 0 ? 2 : 1)
                          : std::numeric_limits<double>::quiet_NaN();
    found.push_back(mode);
  }
  std::sort(found.begin(), found.end(), [](const DriveMode& a, const DriveMode& b) {
    return std::pair(a.frequency, a.rate) < std::pair(b.frequency, b.rate);
  });
  return found;
}

void require_continuous(const Drive& drive) {
  require_linear(drive);
  if (drive.controller.cycle > 0)
    throw InputError("controller.cycle", drive.controller.cycle,
                     "must be 0: only a continuous controller has modes");
}

const char* nonlinear(const Friction& f) {
  if (f.coulomb != 0) return "friction.coulomb";
  if (f.breakaway != 0) return "friction.breakaway";
  return nullptr;
}

const char* nonlinear(const Mass& m) {
  if (m.backlash != 0) return "backlash";
  if (m.efficiency != 1) return "efficiency";
  if (m.gravity_torque != 0) return "gravity_torque";
  return nonlinear(m.friction);
}

double value_of(const DriveSample& s, DriveOutput output) {
  switch (output) {
    case DriveOutput::torque:
      return s.torque;
    case DriveOutput::following_error:
      return s.following_error;
    case DriveOutput::load_error:
      return s.load - s.reference;
    case DriveOutput::load:
      return s.load;
  }
  return 0;
}

}  // namespace

std::optional<std::string> nonlinearity(const Drive& drive) {
  if (const char* key = nonlinear(drive.motor.friction)) return std::string("motor.") + key;
  for (std::size_t i = 0; i < drive.train.size(); ++i)
    if (const char* key = nonlinear(drive.train[i]))
      return "mass[" + std::to_string(i + 1) + "]." + key;
  if (drive.controller.encoder_counts != 0) return "controller.encoder_counts";
  return std::nullopt;
}

ExactRun exact_run(const Trajectory& reference, const Drive& drive, std::span<const double> times) {
  require_linear(drive);
  require_times(times, reference.start());
  return drive.controller.cycle > 0 ? validate_detail::sampled_run(reference, drive, times)
                                    : continuous_run(reference, drive, times);
}

ExactRun exact_run(const Table& reference, const Drive& drive, std::span<const double> times) {
  if (reference.axis() == Domain::master)
    throw InputError("axis", "master", "must be time: a drive follows a motion over time");
  return exact_run(reference.curve<OverTime>(), drive, times);
}

ExactRun exact_period(const Trajectory& period, const Drive& drive, std::span<const double> times) {
  require_valid(drive);
  validate_detail::require_steady(drive);
  require_times(times, period.start());
  const double end = period.end();
  if (!times.empty() && times.back() > end + rounded_sum * period.length())
    throw InputError("times[" + std::to_string(times.size()) + "]", times.back(),
                     "must not be after the end of the period, " + number(end));
  std::vector<double> within(times.begin(), times.end());
  for (double& t : within) t = std::min(t, std::nextafter(end, period.start()));
  ExactRun run = continuous_run(period, drive, within, true);
  for (std::size_t i = 0; i < times.size(); ++i) run.samples[i].time = times[i];
  return run;
}

std::vector<DriveMode> free_vibration(const Trajectory& reference, const Drive& drive) {
  require_continuous(drive);
  const LinearSystem system = balanced(validate_detail::drive_system(drive));
  const Eigen::VectorXd rest = validate_detail::equilibrium(system);
  ExactPath path(system, reference, reference.length(), {rest, 0});
  return modes_of(system, path.whole().state - rest, 1 / radians_per_unit(drive));
}

std::vector<DriveMode> modes(const Drive& drive) {
  require_continuous(drive);
  const LinearSystem system = balanced(validate_detail::drive_system(drive));
  return modes_of(system, Eigen::VectorXd::Zero(system.states()), 0);
}

std::function<std::vector<double>(const Trajectory&)> response(const Drive& drive,
                                                               DriveOutput output,
                                                               std::vector<double> times,
                                                               bool periodic) {
  require_linear(drive);
  if (periodic) validate_detail::require_steady(drive);
  require_times(times, 0);
  return [drive, output, times = std::move(times), periodic](const Trajectory& reference) {
    std::vector<double> at = times;
    for (double& t : at) t += reference.start();
    const ExactRun run =
        periodic ? exact_period(reference, drive, at) : exact_run(reference, drive, at);
    std::vector<double> values;
    values.reserve(run.samples.size());
    for (const DriveSample& s : run.samples) values.push_back(value_of(s, output));
    return values;
  };
}

}  // namespace jounce
