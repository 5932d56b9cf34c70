// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/driven.hpp"

#include "jounce/design/reference.hpp"

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

}  // namespace jounce
