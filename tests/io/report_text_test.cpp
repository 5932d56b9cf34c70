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

TEST(ReportText, CountsWhatItDoesNotShow) {
  Report report;
  for (int i = 0; i < 25; ++i)
    report.findings.push_back({"limit/velocity", "", "velocity", 0, 2, 1, -1, true, {}, "", {}});
  const std::string text = full_text(report, {{"s", "mm"}, false, {}});
  EXPECT_NE(text.find("... and 15 more findings"), std::string::npos);
}

}  // namespace
}  // namespace jounce
