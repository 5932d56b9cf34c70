// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/run_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace jounce::run_text_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

ExecutorSummary two_axes() {
  ExecutorSummary summary;
  summary.axes = {{.name = "feeder", .finished = 2, .position = 1.5},
                  {.name = "knife", .stopped = 1, .fault = Cause::following_error}};
  summary.cycle.ticks = 1000;
  summary.lateness[3] = 1000;
  return summary;
}

TEST(SummaryText, NamesEachAxisAndItsFault) {
  const std::string text = summary_text(two_axes());
  EXPECT_THAT(text, StartsWith("feeder: 2 motions finished, 0 stopped; position 1.5\n"));
  EXPECT_THAT(text, HasSubstr("knife: fault: following_error: "));
  EXPECT_THAT(text,
              HasSubstr("1000 ticks, 0 of them late; largest delay 0.000 ms; 99.9 % of the ticks "
                        "began within 8 us of their time, and 99.9 % took at most"));
  ExecutorSummary alone = two_axes();
  alone.axes.pop_back();
  EXPECT_THAT(summary_text(alone), StartsWith("2 motions finished"));
}

TEST(SummaryText, IsWholeAsJson) {
  const auto document = nlohmann::json::parse(summary_json(two_axes()));
  EXPECT_EQ(document["axes"][1]["fault"], "following_error");
  EXPECT_EQ(document["lateness_us"][3], 1000);
}

TEST(MissingParts, AreSentences) {
  ExecutorSummary summary = two_axes();
  EXPECT_THAT(missing_parts(summary, "run.csv"), IsEmpty());
  summary.cycle.lost = 3;
  summary.axes[1].log_truncated = true;
  EXPECT_THAT(missing_parts(summary, "run.csv"),
              ElementsAre("the log lacks 3 ticks: they could not be written in time",
                          "the log of knife is cut off: run.knife.csv.truncated"));
  EXPECT_THAT(missing_parts(summary, ""), IsEmpty()) << "without a log, no tick is missing";
  summary.record_lost = 7;
  EXPECT_THAT(missing_parts(summary, ""),
              ElementsAre("the record is incomplete: 7 cycles are missing"));
  summary.lost_name = "feeder";
  EXPECT_THAT(missing_parts(summary, ""), ElementsAre(HasSubstr("has the name feeder")));
}

TEST(UpText, NamesTheAxesAndTheNextCommand) {
  std::vector<ExecutorOptions> axes(2);
  axes[0].receiver.executor = "feeder";
  axes[1].receiver.executor = "knife";
  EXPECT_EQ(up_text(axes, true), "feeder, knife: up, enabled");
  EXPECT_EQ(up_text(axes, false),
            "feeder, knife: up, disabled; enable each, in this order: jounce order feeder enable, "
            "jounce order knife enable");
  axes.push_back(axes.front());
  axes.back().receiver.executor = "plotter";
  axes.back().enable = false;  // a group
  EXPECT_EQ(up_text(axes, true),
            "feeder, knife: up, enabled; plotter: up, disabled; enable it with: jounce order "
            "plotter enable");
}

TEST(UpText, StatesThatThePositionOfADriveIsNotMeasured) {
  std::vector<ExecutorOptions> axes(1);
  axes[0].receiver.executor = "feeder";
  axes[0].axis.position = 63.5;
  axes[0].units.position = "mm";
  EXPECT_EQ(up_text(axes, true), "feeder: up, enabled") << "no drive: the setpoint is the position";
  axes[0].drive = std::make_shared<NullDrive>(63.5);
  EXPECT_EQ(up_text(axes, true),
            "feeder: up, enabled; the position is that of the spec, not measured: feeder 63.5 mm");
}

}  // namespace
}  // namespace jounce::run_text_test
