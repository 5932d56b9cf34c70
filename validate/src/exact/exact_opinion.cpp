// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/validate/linear_drive.hpp"
#include "jounce/validate/loop.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

double stroke(const std::vector<DriveSample>& samples) {
  const auto [least, greatest] = std::minmax_element(
      samples.begin(), samples.end(),
      [](const DriveSample& a, const DriveSample& b) { return a.reference < b.reference; });
  return greatest->reference - least->reference;
}

double share_of(double difference, double of) {
  return difference == 0 ? 0
                         : std::abs(difference) / std::max(of, std::numeric_limits<double>::min());
}

/// True if the torque steps at t, where a sample may be from either side.
bool steps(const Trajectory& reference, const Controller& controller, double t) {
  const double near = rounded_input * reference.length();
  const auto breaks = reference.breaks();
  const auto after = std::lower_bound(breaks.begin(), breaks.end(), t - near);
  if (after != breaks.end() && *after <= t + near) return true;
  if (controller.cycle == 0) return false;
  const double gone = t - reference.start() - controller.delay;
  return std::abs(gone - std::nearbyint(gone / controller.cycle) * controller.cycle) <= near;
}

/// The scale of differences of torque: the peak, or the torque that a sampled controller, which differentiates
/// the angle over a cycle, derives from the stroke.
double torque_size(const DriveResult& run, const Drive& drive, double stroke) {
  const Controller& c = drive.controller;
  const double radians = 2 * std::numbers::pi / drive.position_per_rev;
  const double sampled = c.cycle > 0 ? c.velocity_gain * radians * stroke / c.cycle : 0;
  return std::max(std::abs(run.torque.value), sampled);
}

/// The greatest difference of two runs, in motor, load and torque.
Peak worst(const DriveResult& run, const ExactRun& exact, const Trajectory& reference,
           const Drive& drive) {
  const double length = stroke(run.samples);
  const double most = torque_size(run, drive, length);
  Peak peak;
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const DriveSample& a = run.samples[i];
    const DriveSample& b = exact.samples[i];
    const double torque =
        steps(reference, drive.controller, a.time) ? 0 : share_of(a.torque - b.torque, most);
    for (const double now :
         {share_of(a.motor - b.motor, length), share_of(a.load - b.load, length), torque})
      if (!(now <= peak.value)) peak = {now, a.time};
  }
  return peak;
}

}  // namespace

std::optional<Finding> exact_opinion(const SignalView& reference, const Drive& drive,
                                     const DriveResult& run, double tolerance, bool periodic) {
  if (run.samples.empty() || !run.integration.ok() || !run.saturation.empty() ||
      nonlinearity(drive))
    return std::nullopt;
  const std::optional<Trajectory> exact = reference.trajectory();
  if (!exact) return std::nullopt;
  std::vector<double> times;
  for (const DriveSample& s : run.samples) times.push_back(s.time);
  const ExactRun other =
      periodic ? exact_period(*exact, drive, times) : exact_run(*exact, drive, times);
  const Peak peak = worst(run, other, *exact, drive);
  Finding finding;
  finding.rule = "drive/exact";
  finding.quantity = "disagreement";
  finding.unit = "of the range";
  finding.where = peak.where;
  finding.value = peak.value;
  finding.limit = 100 * tolerance;
  finding.margin = (finding.limit - finding.value) / finding.limit;
  finding.broken = !(finding.value <= finding.limit);
  if (finding.broken && unstable_loop(drive))
    return std::nullopt;  // rounding grows with the motion
  if (finding.broken)
    finding.advice =
        "the integration and the exact solution disagree: please report this as a defect";
  return finding;
}

}  // namespace jounce
