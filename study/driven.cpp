#include "jounce/study/driven.hpp"

#include "jounce/study/reference.hpp"

namespace jounce {

DriveResult driven(const Input& input, std::size_t samples) {
  const DriveSpec& drive = input.drive.value();
  const Reference reference = table_reference(input);
  DriveResult result =
      drive_through(view(reference), drive.drive,
                    {.settle = drive.settle, .samples = samples, .limits = drive.limits});
  for (Finding& finding : result.report.findings) {
    finding.axis = "drive";
    finding.where_unit = "s";
    if (finding.rule.ends_with("torque") || finding.rule == "drive/saturation")
      finding.unit = "N m";
    else if (finding.unit.empty())
      finding.unit = input.labels.units.position;
  }
  return result;
}

}  // namespace jounce
