// SPDX-License-Identifier: Apache-2.0
// Warnings about the shape of a cam: the points of the spec may require an overshoot or a reversal.
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "jounce/base/file.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/input.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::cam_warnings_test {
namespace {

using testing::Contains;
using testing::IsEmpty;

/// The warnings of a cam with one segment from 0 to 0 mm with this law.
std::vector<std::string> warnings_of(const std::string& law) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "cam.toml";
  write_file(file,
             "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
             "start = { master = 0, slave = 0, geo_velocity = 0, geo_acceleration = 0 }\n"
             "[[segment]]\n" +
                 law +
                 "\nend = { master = 360, slave = 0, geo_velocity = 0, geo_acceleration = 0 }\n");
  std::vector<std::string> rules;
  for (const Finding& f : checked(read_inputs(file).front(), 2, {}).findings)
    if (f.severity == Severity::warning) rules.push_back(f.rule.text());
  return rules;
}

TEST(CamWarnings, ExceptTheShapeThatThePointsRequire) {
  EXPECT_THAT(
      warnings_of("law = \"quintic_spline\"\npoints = [{ master = 90, slave = 20 }, { master "
                  "= 180, slave = 40 }, { master = 270, slave = 20 }]"),
      IsEmpty());
}

TEST(CamWarnings, ReportAnOscillationBetweenThePoints) {
  EXPECT_THAT(warnings_of("law = \"polynomial\"\npoints = [{ master = 10, slave = 20 }, { master = "
                          "20, slave = 0 }]"),
              Contains("warning/overshoot"));
}

}  // namespace
}  // namespace jounce::cam_warnings_test
