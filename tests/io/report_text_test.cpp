#include "jounce/io/report_text.hpp"

#include <gtest/gtest.h>

#include "jounce/io/make.hpp"

namespace jounce {
namespace {

struct Checked {
  Report report;
  Labels labels;
};

Checked fig_6_14() {
  const Spec spec = read_spec(JOUNCE_SOURCE_DIR "/examples/pmc600-cam/cam.toml");
  Made made = make(spec);
  return {check(std::get<Cam>(made.curve), spec.limits),
          {spec.units, true, std::move(made.segments)}};
}

TEST(ReportText, SaysWhereByHowMuchAndInWhichUnit) {
  const auto [report, labels] = fig_6_14();
  EXPECT_EQ(sentence(report.findings[0], labels),
            "geo_velocity -3.39227 pulse/pulse at 241.898 pulse (segment 3 return) exceeds the "
            "limit -3 by 13.1 %");
  EXPECT_EQ(one_line(report, labels),
            "2 findings; the worst: " + sentence(report.findings[0], labels));
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
  EXPECT_EQ(one_line(report, labels), "nothing was limited, so nothing was checked (1 warning)");
  EXPECT_EQ(sentence(note, labels),
            "Ca 5.7735 at 25 deg is 21.5 % above 4.753, the least for its jerk");
  const std::string text = full_text(report, labels);
  EXPECT_NE(text.find("  warn   warning/velocity_overshoot geo_velocity 1.512 mm/deg at 72 deg is "
                      "beyond 1, at which the segment ends"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("bound/"), std::string::npos) << "a note is no line";
  EXPECT_EQ(text.find("more findings"), std::string::npos);
  const std::string json = to_json(report, labels);
  EXPECT_NE(json.find("\"severity\":\"warning\""), std::string::npos);
  EXPECT_NE(json.find("\"severity\":\"note\""), std::string::npos);
}

TEST(ReportText, CountsWhatItDoesNotShow) {
  Report report;
  for (int i = 0; i < 25; ++i)
    report.findings.push_back({"limit/velocity", "", "velocity", 0, 2, 1, -1, true, {}, "", {}});
  const std::string text = full_text(report, {{"s", "mm"}, false, {}});
  EXPECT_NE(text.find("... and 15 more findings"), std::string::npos);
}

}  // namespace
TEST(ReportText, TakesTogetherWhatNobodyWouldRead) {
  const auto all = groups(100'000, {}, 60);
  ASSERT_EQ(all.size(), 60u);
  EXPECT_EQ(all.front().label, "1 to 1666");
  EXPECT_EQ(all.front().first, 0u);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_EQ(all[i].first, all[i - 1].last + 1);
  EXPECT_EQ(all.back().last, 99'999u);
  EXPECT_EQ(groups(60, {}, 60).back().label, "60");
  EXPECT_EQ(groups(61, {}, 60).back().label, "60 to 61");
}

}  // namespace jounce
