// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/report_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"

namespace jounce::report_text_test {
namespace {

struct Checked {
  Report report;
  Labels labels;
};

Checked fig_6_14() {
  const Spec spec = read_spec(JOUNCE_SOURCE_DIR "/examples/pmc600-cam/cam.toml");
  Made made = make(spec);
  return {check(std::get<Cam>(*made.curve), spec.limits),
          {spec.units, true, std::move(made.segments)}};
}

TEST(ReportText, StatesWhereByHowMuchAndInWhichUnit) {
  const auto [report, labels] = fig_6_14();
  EXPECT_EQ(sentence(report.findings[0], labels),
            "geo_velocity -3.39227 pulse/pulse at 241.898 pulse (segment 3 return) exceeds the "
            "limit -3 pulse/pulse by 13.1 %");
  EXPECT_EQ(one_line(report, labels),
            "2 findings; the worst: " + sentence(report.findings[0], labels));
}

/// A limit that is typed back is kept, and a value that breaks it is never printed equal to it.
TEST(ReportText, ALimitIsRoundedToItsPermittedSide) {
  Finding f;
  f.rule = "limit/velocity";
  f.quantity = "velocity";
  f.value = 900;
  f.limit = 272.788567;
  f.margin = -2.3;
  f.broken = true;
  const Labels labels{{"s", "mm"}, false, {}};
  const auto has = [&](const char* text) {
    return sentence(f, labels).find(text) != std::string::npos;
  };
  EXPECT_TRUE(has("exceeds the limit 272.788 mm/s")) << sentence(f, labels);
  f.value = -900;
  f.limit = -272.788567;
  EXPECT_TRUE(has("exceeds the limit -272.788 mm/s")) << sentence(f, labels);
  f.value = 300.0000004;
  f.limit = 300;
  EXPECT_TRUE(has("velocity 300.0000004 mm/s at 0 s exceeds the limit 300 mm/s"))
      << sentence(f, labels);
  f.rule = "limit/position_min";
  f.quantity = "position";
  f.value = -1;
  f.limit = 0.1234567;
  EXPECT_TRUE(has("is below the limit 0.123457 mm")) << sentence(f, labels);
}

TEST(ReportText, AnExcessByRoundingHasItsValue) {
  Finding f;
  f.rule = "limit/acceleration";
  f.quantity = "acceleration";
  f.value = -1004.5;
  f.limit = -1000;
  const Labels labels{{"s", "mm"}, false, {}};
  EXPECT_EQ(sentence(f, labels),
            "acceleration -1004.5 mm/s^2 at 0 s exceeds the limit -1000 mm/s^2 by 0.45 %, through "
            "the rounding of its knots");
  f.value = -1000.0000001;
  EXPECT_EQ(sentence(f, labels),
            "acceleration -1000 mm/s^2 at 0 s just meets the limit -1000 mm/s^2");
}

TEST(ReportText, AValueUnderALowerLimitIsBelowIt) {
  Finding f;
  f.rule = "limit/slave";
  f.quantity = "slave";
  f.where = 280;
  f.value = 63.5;
  f.limit = 70;
  f.margin = -0.0929;
  f.broken = true;
  const Labels labels{{"deg", "mm"}, true, {}};
  EXPECT_TRUE(sentence(f, labels).ends_with("is 9.29 % below the lower limit 70 mm"))
      << sentence(f, labels);
  f.value = -80;
  f.limit = -70;
  EXPECT_TRUE(sentence(f, labels).ends_with("exceeds the limit -70 mm by 9.29 %"))
      << sentence(f, labels);
}

TEST(ReportText, JsonHasEveryNumberInFull) {
  const auto [report, labels] = fig_6_14();
  const std::string json = to_json(report, labels);
  EXPECT_NE(json.find("\"ok\":false"), std::string::npos);
  EXPECT_NE(json.find("-3.39227080286"), std::string::npos);
  EXPECT_NE(json.find("\"unit\":\"pulse/pulse\""), std::string::npos);
  EXPECT_NE(json.find("\"segment\":3"), std::string::npos);
}

TEST(ReportText, WarnsWithoutBreakingAndKeepsNotesForMachines) {
  Report report;
  Finding warning;
  warning.rule = "warning/velocity_overshoot";
  warning.quantity = "geo_velocity";
  warning.where = 72;
  warning.value = 1.512;
  warning.limit = 1;
  warning.margin = -0.3;
  warning.severity = Severity::warning;
  warning.advice = "take a longer way";
  Finding note;
  note.rule = "bound/acceleration_for_jerk";
  note.quantity = "Ca";
  note.where = 25;
  note.value = 5.7735;
  note.limit = 4.753;
  note.margin = 0.2147;
  note.severity = Severity::note;
  report.findings = {note, warning};
  sort(report);
  const Labels labels{{"deg", "mm"}, true, {}};
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.warnings(), 1U);
  EXPECT_EQ(one_line(report, labels), "no limits are given (1 warning)");
  EXPECT_EQ(sentence(note, labels),
            "Ca 5.7735 at 25 deg is 21.5 % above 4.753, the minimum for its jerk");
  const std::string text = full_text(report, labels);
  EXPECT_NE(text.find("  warn   warning/velocity_overshoot geo_velocity 1.512 mm/deg at 72 deg "
                      "exceeds 1 mm/deg, the geo_velocity at the end of the segment"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("bound/"), std::string::npos) << "a note is no line";
  EXPECT_EQ(text.find("more findings"), std::string::npos);
  const std::string json = to_json(report, labels);
  EXPECT_NE(json.find("\"severity\":\"warning\""), std::string::npos);
  EXPECT_NE(json.find("\"severity\":\"note\""), std::string::npos);
}

// A cam read from a drawing ends at 1.3e-10 mm instead of 0.
TEST(ReportText, ARoundingErrorBesideTheTravelIsZero) {
  Finding f;
  f.rule = "warning/overshoot";
  f.quantity = "position";
  f.where = 72;
  f.value = -0.02;
  f.limit = 1.30878e-10;
  f.margin = -0.001;  // the travel is 20 mm
  f.severity = Severity::warning;
  const Labels labels{{"deg", "mm"}, true, {}};
  EXPECT_EQ(sentence(f, labels),
            "position -0.02 mm at 72 deg is beyond the segment's end 0 mm by 0.02 mm");
  f.limit = 1e-4;
  EXPECT_NE(sentence(f, labels).find("end 0.0001 mm by"), std::string::npos) << "not rounding";
  EXPECT_EQ(rounded(2e-9, 1), "2e-9");
  EXPECT_EQ(rounded(2e-9, 10), "0");
}

Finding joint(const char* rule, const char* quantity, double value) {
  Finding f;
  f.rule = rule;
  f.quantity = quantity;
  f.where = 460;
  f.value = value;
  f.has_limit = false;
  return f;
}

Finding half_of_a_limit() {
  Finding f;
  f.rule = "limit/geo_velocity";
  f.quantity = "geo_velocity";
  f.value = 0.5;
  f.limit = 1;
  f.margin = 0.5;
  return f;
}

TEST(ReportText, AFigureWithoutALimitHasItsValue) {
  const Labels labels{{"deg", "mm"}, true, {}};
  Finding start = joint("coupling/start", "position", -40.36);
  start.broken = true;
  EXPECT_EQ(sentence(start, labels),
            "position steps by -40.36 mm where the slave engages, at 460 deg");
  Finding ramp = joint("coupling/ramp", "velocity", 150);
  ramp.unit = "mm/s";
  ramp.where = 0.03;
  ramp.where_unit = "s";
  EXPECT_EQ(sentence(ramp, labels), "the ramp reaches velocity 150 mm/s after 0.03 s");
  EXPECT_EQ(sentence(joint("polydyne/geo_acceleration", "step of geo_acceleration", 5.83), labels),
            "geo_acceleration steps by 5.83 mm/deg^2 at 460 deg");
  const std::string json = to_json({{start}}, labels);
  EXPECT_NE(json.find("\"limit\":null,\"margin\":null"), std::string::npos) << json;
}

TEST(ReportText, TheHeadlineIsALimitOrStatesThatNoneIsGiven) {
  const Labels labels{{"deg", "mm"}, true, {}};
  Finding continuity;
  continuity.rule = "continuity/position";
  continuity.quantity = "step of position";
  const Finding limit = half_of_a_limit();
  Report report{{joint("coupling/ramp", "velocity", 150), continuity}};
  for (const char* rule :
       {"witness/position", "played/table", "drive/integration", "drive/exact"}) {
    Finding proof = half_of_a_limit();
    proof.rule = rule;
    report.findings.push_back(proof);
  }
  EXPECT_EQ(one_line(report, labels), "no limits are given; the curve is continuous");
  report.findings.push_back(limit);
  EXPECT_EQ(one_line(report, labels), "all limits hold; the closest: " + sentence(limit, labels));
  EXPECT_EQ(one_line({}, labels), "no limits are given");
}

TEST(ReportText, AMasterThatNoSpeedPermitsHasNoShareOfItsLimit) {
  const Labels labels{{"deg", "mm"}, true, {}};
  Finding f;
  f.rule = "limit/master_velocity";
  f.quantity = "master_velocity";
  f.value = 360;
  f.limit = 0;
  f.margin = -360;
  f.broken = true;
  EXPECT_THAT(sentence(f, labels), testing::HasSubstr("at any speed of the master"));
  EXPECT_THAT(sentence(f, labels), testing::Not(testing::HasSubstr("times")));
}

TEST(ReportText, TheHeadlineNamesLimitsThatTheCheckDoesNotUse) {
  Finding none;
  none.rule = "warning/no_limits";
  none.quantity = "limits.slave";
  none.severity = Severity::warning;
  none.has_limit = false;
  const Labels labels{{"deg", "mm"}, true, {}};
  EXPECT_EQ(one_line({{none}}, labels), "limits.slave is not checked (1 warning)");
  EXPECT_THAT(sentence(none, labels), testing::HasSubstr("limits.slave is not checked"));
}

TEST(ReportText, ASegmentOfSeveralPiecesKeepsItsNumber) {
  const Labels labels{
      {"deg", "mm"}, true, {"1 rise", "1 rise", "1 rise", "2 dwell", "3 fall", "3 fall"}};
  Finding f;
  f.rule = "limit/geo_velocity";
  f.segment = 5;
  const std::string json = to_json({{f}}, labels);
  EXPECT_NE(json.find("\"segment\":3,\"segment_name\":\"3 fall\",\"piece\":6"), std::string::npos)
      << json;
  EXPECT_EQ(labels.number_of_segment(0), 1U);
  EXPECT_EQ(Labels{}.number_of_segment(4), 5U);
}

TEST(ReportText, CountsWhatItDoesNotShow) {
  Report report;
  for (int i = 0; i < 25; ++i)
    report.findings.push_back({"limit/velocity", "", "velocity", 0, 2, 1, -1, true, {}, "", {}});
  const std::string text = full_text(report, {{"s", "mm"}, false, {}});
  EXPECT_NE(text.find("... and 15 more findings (15 BROKEN): --json prints all of them"),
            std::string::npos);
}

TEST(ReportText, WhatHasNoLimitIsNamedBesideTheLimitsThatHold) {
  const Labels labels{{"deg", "mm"}, true, {}};
  const Finding limit = half_of_a_limit();
  Finding jerk = joint("unlimited/geo_jerk", "geo_jerk", -0.25);
  jerk.severity = Severity::note;
  const Report report{{limit, jerk}};
  EXPECT_EQ(one_line(report, labels), "all limits hold; the closest: " + sentence(limit, labels) +
                                          "; not limited: geo_jerk (up to 0.25 mm/deg^3)");
  EXPECT_EQ(sentence(jerk, labels), "geo_jerk has no limit; its peak is -0.25 mm/deg^3 at 460 deg");
  EXPECT_EQ(one_line({{jerk}}, labels), "no limits are given");
}

}  // namespace
TEST(ReportText, SummarizesLongLists) {
  const auto all = groups(100'000, {}, 60);
  ASSERT_EQ(all.size(), 60u);
  EXPECT_EQ(all.front().label, "1 to 1666");
  EXPECT_EQ(all.front().first, 0u);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_EQ(all[i].first, all[i - 1].last + 1);
  EXPECT_EQ(all.back().last, 99'999u);
  EXPECT_EQ(groups(60, {}, 60).back().label, "60");
  EXPECT_EQ(groups(61, {}, 60).back().label, "60 to 61");
}

}  // namespace jounce::report_text_test
