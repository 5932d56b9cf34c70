// SPDX-License-Identifier: Apache-2.0
// A step of the acceleration with a limit of the jerk, and a step of the velocity with a limit of the acceleration:
// `check` of the spec, of its table against the spec, and of the table with limits give one verdict, and it is that of
// an axis with the same limits. The steps are known: the cubic through points of constant acceleration is this motion.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/axis/job.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/detail/file_check.hpp"
#include "jounce/io/table_file.hpp"

#include "design/src/input/against_spec.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::cli {
namespace {

constexpr double acceleration = 250;               // mm/s^2, at once, at rest
constexpr double permitted = acceleration / 1e-3;  // the jerk that permits this step within 1 ms

const Finding* broken(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.broken && f.rule.text() == rule) return &f;
  return nullptr;
}

class StepVerdict : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    const std::string path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }
  /// 5 mm in 0.3 s: acceleration, constant velocity, deceleration.
  std::string imported(double jerk) {
    write("points.csv",
          "time [s],position [mm],velocity [mm/s]\n0,0,0\n0.05,0.3125,12.5\n0.1,1.25,25\n"
          "0.2,3.75,25\n0.25,4.6875,12.5\n0.3,5,0\n");
    return write(
        "import.toml",
        "jounce = 1\nkind = \"pvt\"\nname = \"import\"\nunits = { position = \"mm\", time = "
        "\"s\" }\npoints = \"points.csv\"\n[limits]\nvelocity = 25\nacceleration = 250\n"
        "jerk = " +
            std::to_string(jerk) + "\n");
  }
  /// A rise of 45 mm in 100 deg and back, by a law with continuous acceleration, as a table.
  std::string cam(const std::string& rule, const std::string& tolerance, const char* limits) {
    return write("cam.toml",
                 "jounce = 1\nkind = \"cam\"\nname = \"jaw\"\nperiodic = true\n"
                 "units = { master = \"deg\", position = \"mm\" }\nstart = { master = 0, slave = 0 "
                 "}\n[[segment]]\nlaw = \"345\"\nend = { master = 100, slave = 45 }\n"
                 "[[segment]]\nlaw = \"345\"\nend = { master = 360, slave = 0 }\n"
                 "[limits.slave]\n" +
                     std::string(limits) +
                     "\n[master]\nvelocity = 600\n[disc]\nbase_radius = 60\n"
                     "roller_radius = 12\n[table]\nrule = \"" +
                     rule + "\"\ntolerance = " + tolerance + "\n");
  }
  Report check(const std::string& file, const CheckOptions& options = {}) {
    axes_ = read_inputs(file);
    return check_reports(axes_, options).front();
  }
  std::string table_of(const std::string& spec) {
    const Input made = read_inputs(spec).front();
    return write("made.csv", table_text("made.csv", made.table));
  }

  test::TemporaryFolder folder_;
  std::vector<Input> axes_;
};

TEST_F(StepVerdict, OfAnImportedMotionIsThatOfTheAxis) {
  for (const double jerk : {10.0, permitted * (1 - 1e-6), permitted * (1 + 1e-6)}) {
    const bool holds = jerk > permitted;
    const std::string spec = imported(jerk);
    const Report of_spec = check(spec);
    EXPECT_EQ(of_spec.ok(), holds) << jerk;
    const Table table = axes_.front().table.table;
    const std::string file = table_of(spec);
    EXPECT_EQ(check(file, {.against = spec}).ok(), holds) << jerk;
    EXPECT_EQ(check(file, {.limits = {"jerk=" + std::to_string(jerk)}}).ok(), holds) << jerk;
    AxisConfig axis;
    axis.limits = {.velocity = 25, .acceleration = 250, .jerk = jerk};
    const auto refusal = admit(Job(1, std::make_shared<const Table>(table), nullptr), axis, 0.0);
    EXPECT_EQ(!refusal, holds) << jerk;
    if (holds) continue;
    EXPECT_EQ(refusal->cause, Cause::acceleration_step);
    const Finding* const step = broken(of_spec, "limit/acceleration_step");
    ASSERT_NE(step, nullptr);
    EXPECT_NEAR(step->value, acceleration, 1e-9);
    EXPECT_NEAR(step->limit, jerk * 1e-3, 1e-9 * jerk);
    EXPECT_NEAR(refusal->value, step->value, 1e-9);
    EXPECT_NEAR(refusal->limit, step->limit, 1e-9);
  }
}

TEST_F(StepVerdict, TheRaisedLimitOfTheRemedyHolds) {
  const Report report = check(imported(10));
  const Finding* const step = broken(report, "limit/acceleration_step");
  ASSERT_NE(step, nullptr);
  EXPECT_THAT(step->advice, ::testing::HasSubstr("raise the jerk limit to 250000 mm/s^3"));
  EXPECT_TRUE(check(imported(250000)).ok());
}

/// Verdicts on a table: in its spec, against its spec, and with the limits on the command line.
TEST_F(StepVerdict, OfACubicTableIsOne) {
  // The steps of a coarse table are too great for the limit, those of a fine one are not.
  for (const auto& [tolerance, holds] : {std::pair{"0.05", false}, {"1e-6", true}}) {
    const std::string spec = cam("cubic_hermite", tolerance, "jerk = 8e5");
    const Report of_spec = check(spec);
    EXPECT_EQ(of_spec.ok(), holds) << full_text(of_spec, axes_.front().labels);
    const std::string file = table_of(spec);
    const Report against = check(file, {.against = spec});
    EXPECT_EQ(against.ok(), holds) << full_text(against, axes_.front().labels);
    const CheckOptions limits{.limits = {"jerk=8e5"}, .start = {.master_velocity = "600"}};
    const Report limited = check(file, limits);
    EXPECT_EQ(limited.ok(), holds) << full_text(limited, axes_.front().labels);
    for (const Report* report : {&of_spec, &against, &limited})
      EXPECT_EQ(broken(*report, "limit/acceleration_step") == nullptr, holds);
  }
}

TEST_F(StepVerdict, OfALinearTableIsOne) {
  for (const auto& [tolerance, holds] : {std::pair{"0.001", true}, {"0.005", false}}) {
    const std::string spec = cam("linear", tolerance, "acceleration = 12000");
    const Report of_spec = check(spec);
    const Report against = check(table_of(spec), {.against = spec});
    for (const Report* report : {&of_spec, &against}) {
      EXPECT_EQ(report->ok(), holds) << full_text(*report, axes_.front().labels);
      EXPECT_EQ(broken(*report, "limit/velocity_step") == nullptr, holds);
      EXPECT_EQ(broken(*report, "continuity/geo_velocity"), nullptr);
      EXPECT_EQ(broken(*report, "disc/corner"), nullptr) << "the plate follows the curve";
    }
    if (!holds) continue;
    const auto states_the_step = [](const Finding& f) {
      return f.rule == "joint/geo_velocity" && f.value > 0;
    };
    EXPECT_TRUE(std::any_of(of_spec.findings.begin(), of_spec.findings.end(), states_the_step));
    EXPECT_TRUE(std::any_of(against.findings.begin(), against.findings.end(), states_the_step));
  }
}

/// The step at a joint of line and arc that the program does not round is a note.
TEST_F(StepVerdict, OfAPathWithAPermittedStepIsANote) {
  axes_ = read_inputs(JOUNCE_SOURCE_DIR "/examples/himc-path/stadium.toml");
  const std::vector<Report> reports = check_reports(axes_, {});
  ASSERT_EQ(axes_.at(1).axis, "y");
  EXPECT_TRUE(reports.at(1).ok());
  const auto& findings = reports.at(1).findings;
  const auto step = std::find_if(findings.begin(), findings.end(),
                                 [](const Finding& f) { return f.rule == "joint/acceleration"; });
  ASSERT_NE(step, findings.end());
  EXPECT_NEAR(step->value, 100.0 * 100.0 / 50, 1) << "v^2 / r";
  EXPECT_EQ(step->severity, Severity::note);
}

}  // namespace
}  // namespace jounce::cli
