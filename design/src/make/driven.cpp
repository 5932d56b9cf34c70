// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/driven.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/design/detail/reference.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce {
namespace {

/// Unit of the value of a finding; "" is the unit of the position.
std::string unit_of(const Rule& rule) {
  if (rule.name().ends_with("torque") || rule == "drive/saturation") return "N m";
  if (rule.name().ends_with("velocity")) return "rad/s";
  if (rule == "drive/current") return "A";
  if (rule == "drive/i2t") return "of the limit";
  return rule == "drive/settling_time" || rule == "drive/integration" ? "s" : "";
}

}  // namespace

DriveResult driven(const Input& input, std::size_t samples) {
  const DriveSpec& drive = input.drive.value();
  const Reference reference = table_reference(input);
  DriveResult result = drive_through(view(reference), drive.drive, drive.options(samples));
  for (Finding& finding : result.report.findings) {
    finding.axis = "drive";
    if (finding.where_unit.empty()) finding.where_unit = "s";
    if (finding.unit.empty()) finding.unit = unit_of(finding.rule);
    if (finding.unit.empty()) finding.unit = input.labels.units.position;
  }
  return result;
}

void add_torque_demand(DriveResult& result, const Input& input) {
  const auto found =
      std::find_if(result.report.findings.begin(), result.report.findings.end(),
                   [](const Finding& f) { return f.broken && f.rule == "drive/saturation"; });
  if (found == result.report.findings.end()) return;
  const bool is_unstable =
      std::any_of(result.report.findings.begin(), result.report.findings.end(),
                  [](const Finding& f) { return f.rule == "drive/stability"; });
  if (is_unstable) return;
  Input free = input;
  constexpr double without_limit = 1e6;  // a multiple of the limit
  free.drive->drive.motor.torque_limit *= without_limit;
  const DriveResult unlimited = driven(free);
  if (!unlimited.integration.ok()) return;
  found->advice = "without this limit, the torque reaches " +
                  six_digits_up(std::abs(unlimited.torque.value)) +
                  " N m: use a motor with this torque_limit, or lower the acceleration " +
                  (input.spec && input.spec->master ? "(with a lower master.velocity) " : "") +
                  "or the inertia";
}

}  // namespace jounce
