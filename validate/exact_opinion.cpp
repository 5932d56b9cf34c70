#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/validate/linear_drive.hpp"

namespace jounce {
namespace {

double stroke(const std::vector<DriveSample>& samples) {
  const auto [least, greatest] = std::minmax_element(
      samples.begin(), samples.end(),
      [](const DriveSample& a, const DriveSample& b) { return a.reference < b.reference; });
  return greatest->reference - least->reference;
}

double share(double difference, double of) {
  return difference == 0 ? 0
                         : std::abs(difference) / std::max(of, std::numeric_limits<double>::min());
}

/// Where two runs differ most, in all that samples hold.
Peak worst(const std::vector<DriveSample>& a, const std::vector<DriveSample>& b, double torque) {
  const double length = stroke(a);
  Peak peak;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const double now :
         {share(a[i].motor - b[i].motor, length), share(a[i].load - b[i].load, length),
          share(a[i].torque - b[i].torque, torque)})
      if (!(now <= peak.value)) peak = {now, a[i].time};
  return peak;
}

}  // namespace

std::optional<Finding> exact_opinion(const SignalView& reference, const Drive& drive,
                                     const DriveResult& run, double tolerance) {
  if (run.samples.empty() || !run.integration.ok() || !run.saturation.empty() ||
      nonlinearity(drive))
    return std::nullopt;
  const std::optional<Trajectory> exact = reference.trajectory();
  if (!exact) return std::nullopt;
  std::vector<double> times;
  for (const DriveSample& s : run.samples) times.push_back(s.time);
  const Peak peak =
      worst(run.samples, exact_run(*exact, drive, times).samples, std::abs(run.torque.value));
  Finding finding;
  finding.rule = "drive/exact";
  finding.quantity = "disagreement";
  finding.unit = "of the range";
  finding.where = peak.where;
  finding.value = peak.value;
  finding.limit = 100 * tolerance;
  finding.margin = (finding.limit - finding.value) / finding.limit;
  finding.broken = !(finding.value <= finding.limit);
  if (finding.broken)
    finding.advice = "the integration and the exact solution disagree: please report it";
  return finding;
}

}  // namespace jounce
