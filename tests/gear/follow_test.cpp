// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/follow.hpp"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/follow_tables.hpp"
#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::follow_test {
namespace {

using test::bridge_7_9;
using test::example_7_7;
using test::example_7_8;
using test::new_7_9;
using test::old_7_9;
using test::shear_cycle;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<double> end_ratios(const FollowSpec& spec) {
  std::vector<double> ends;
  for (const PtRate& r : follow_ratios(spec)) ends.push_back(r.end);
  return ends;
}

const Finding* found(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

std::vector<std::string> rules(const Report& report) {
  std::vector<std::string> all;
  for (const Finding& f : report.findings) all.push_back(f.rule.text());
  return all;
}

auto ratios(std::initializer_list<double> values) {
  return ::testing::Pointwise(::testing::DoubleNear(1e-14), std::vector<double>(values));
}

TEST(Follow, Figure713IsTwoHundredAndFiftyInAfterHalfAThousand) {
  // The event is at master 1000, the ramp ends at 1500, the sync point is at 2250.
  const FollowSpec spec{{{{{500, 250}, {1250, 1000, PtType::even}}}}};
  const SyncCam slave = follow(spec);
  EXPECT_EQ(slave.cam.jet(1500 - 1000)[0], 250);
  EXPECT_EQ(slave.cam.jet(2250 - 1000, Side::left)[0], 1000);
  EXPECT_EQ(slave.cam.jet(500)[1], 1);
  ASSERT_EQ(slave.zones.size(), 1U);
  EXPECT_EQ(slave.zones[0].from, 500);
  EXPECT_EQ(slave.zones[0].to, 1250);
  EXPECT_EQ(slave.zones[0].name, "ratio 1");
}

TEST(Follow, Example76CatchesUpAndThenRunsPeriodically) {
  EXPECT_THAT(end_ratios({{{{{5000, 2500}}}}}), ratios({1}));
  const FollowSpec cycle{{shear_cycle()}, 1};
  EXPECT_THAT(end_ratios(cycle), ratios({1, 0.6, 0.6, 1, 1}));
  EXPECT_TRUE(check(cycle).ok());
  EXPECT_TRUE(check(cycle).findings.empty());
  EXPECT_EQ(master_period(cycle), 10000);
  const Cam cam = follow(cycle).cam;
  EXPECT_EQ(cam.outside(), Extrapolation::advance);
  EXPECT_EQ(cam.jet(10000 * 7e6 + 4000)[0], 8000 * 7e6 + 3400);
  test::expect_invariants(cam, 1);

  const FollowSpec both{{{{{5000, 2500}}}, shear_cycle()}};
  EXPECT_THAT(end_ratios(both), ratios({1, 1, 0.6, 0.6, 1, 1}));
  EXPECT_TRUE(check(both).findings.empty());
  EXPECT_EQ(follow(both).cam.end(), 15000);
  EXPECT_EQ(follow(both).cam.outside(), Extrapolation::refuse);
  EXPECT_FALSE(master_period(both));
}

TEST(Follow, Example76BeginningNormalWouldStepAtEveryCut) {
  FollowTable table = shear_cycle();
  table.segments[0] = {1000, 500, PtType::normal};  // from 0 to 1 in every pass
  for (std::size_t i = 1; i < 5; ++i) table.segments[i].position -= 500;
  const Report report = check(FollowSpec{{table}});
  EXPECT_THAT(rules(report), ElementsAre("follow/wrap_step"));
  EXPECT_TRUE(report.findings[0].broken);
  EXPECT_EQ(report.findings[0].where, 10000);
  EXPECT_NEAR(report.findings[0].value, 1, 1e-14);
  EXPECT_THAT(report.findings[0].advice, HasSubstr("from 1 to 0 from pass to pass"));
}

TEST(Follow, Example77RepeatsFromRest) {
  const FollowSpec spec{{example_7_7()}};
  EXPECT_THAT(end_ratios(spec), ratios({1, 1, 0}));
  EXPECT_TRUE(check(spec).findings.empty());
  EXPECT_EQ(follow(spec).cam.advance(), 40000);
}

TEST(Follow, Example78IsAtRatioOneThroughoutItsMiddle) {
  const FollowSpec spec{{example_7_8()}};
  const SyncCam slave = follow(spec);
  ASSERT_EQ(slave.cam.segments().size(), 802U);
  EXPECT_EQ(slave.cam.end(), 120000);
  EXPECT_EQ(slave.cam.at(120000).position, 100000);
  for (const PtRate& r : follow_ratios(spec)) EXPECT_LE(std::max(r.start, r.end), 1);
  EXPECT_EQ(extrema(slave.cam, 1).max.value, 1);
  ASSERT_EQ(slave.zones.size(), 1U) << "800 even segments of one ratio are one zone";
  EXPECT_EQ(slave.zones[0].from, 20000);
  EXPECT_EQ(slave.zones[0].to, 100000);
  EXPECT_TRUE(check(spec).findings.empty());
}

TEST(Follow, Example78WithOneSegmentLessIsFoundByItsEnd) {
  FollowTable table = example_7_8(799);
  table.end = {120000, 100000};
  const Report report = check(FollowSpec{{table}});
  ASSERT_THAT(rules(report), ElementsAre("follow/end"));
  EXPECT_TRUE(report.findings[0].broken);
  EXPECT_EQ(report.findings[0].value, 119900);
  EXPECT_EQ(report.findings[0].limit, 120000);
  EXPECT_THAT(report.findings[0].advice,
              HasSubstr("which equals segment 2: check whether a segment is missing"));
}

TEST(Follow, Example78WithOneSegmentLessAndTheEndKeptSteps) {
  FollowTable table = example_7_8(799);
  table.segments.back() = {120000, 100000, PtType::stop};
  const Report report = check(FollowSpec{{table}});
  const Finding* f = found(report, "follow/ratio_step");
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(f->where, 99900);
  EXPECT_NEAR(f->value, 2 * 10100.0 / 20100 - 1, 1e-12);
}

TEST(Follow, Example79HandsTheRatioFromTableToTable) {
  FollowTable last = new_7_9();
  last.loops = 0;
  EXPECT_THAT(end_ratios({{old_7_9()}}), ratios({1, 1, 0}));
  EXPECT_THAT(end_ratios({{bridge_7_9()}}), ratios({1, 1, 0.6}));
  const FollowSpec all{{old_7_9(), bridge_7_9(), last}};
  EXPECT_THAT(end_ratios(all), ratios({1, 1, 0, 1, 1, 0.6, 1, 1, 0.6}));
  EXPECT_TRUE(check(all).findings.empty());
  // At master 50 pulse/ms the last table oscillates between 30 and 50.
  const Cam cam = follow(FollowSpec{{last}, 0.6}).cam;
  const Followed slave(cam, Trajectory({line(6000, 0, 300000)}));
  const Range v = extrema(cam, 1);
  EXPECT_NEAR(50 * v.min.value, 30, 1e-12);
  EXPECT_NEAR(50 * v.max.value, 50, 1e-12);
  EXPECT_NEAR(slave.at(3000).velocity, 50 * cam.jet(30000)[1], 1e-12);
}

TEST(Follow, Example79MisprintIsNamed) {
  FollowTable last = new_7_9();
  last.loops = 0;
  const FollowSpec spec{{old_7_9(), bridge_7_9(220000), last}};
  const Report report = check(spec);
  EXPECT_FALSE(report.ok());
  const Finding* f = found(report, "follow/reversal");
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(f->segment, 5U) << "the third segment of table 2";
  EXPECT_EQ(f->where, 60000 + 260000);
  EXPECT_NEAR(f->value, -0.85454545454545, 1e-12);
  EXPECT_THAT(
      f->advice,
      HasSubstr("the master travels 220000, 11 times as far as in the other segments, where the "
                "master travels 20000: check this number"));
  EXPECT_TRUE(f->advice.ends_with("end at the ratio 0.6")) << "the advice omits the consequence";
}

TEST(Follow, ALastTableThatEndsAtARatioIsADeadStop) {
  const FollowSpec spec{{{{{5000, 2500}}}}};
  const SyncCam slave = follow(spec);
  EXPECT_EQ(slave.cam.outside(), Extrapolation::hold);
  EXPECT_EQ(slave.cam.jet(6000)[0], 2500) << "it stays where it ends";
  EXPECT_EQ(slave.cam.jet(6000)[1], 0);
  const Report report = check(spec);
  ASSERT_THAT(rules(report), ElementsAre("follow/open_end"));
  EXPECT_TRUE(report.findings[0].broken);
  EXPECT_EQ(report.findings[0].where, 5000);
  EXPECT_EQ(report.findings[0].value, 1);
}

TEST(Follow, StepsOfEvenAndStopSegmentsAreNamedWithBothRatios) {
  const FollowSpec spec{{{{{100, 50}, {200, 130, PtType::even}, {300, 180, PtType::stop}}}}};
  const Report report = check(spec);
  ASSERT_THAT(rules(report), ElementsAre("follow/ratio_step"));
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.where, 100) << "of two equal steps the first";
  EXPECT_NEAR(f.value, 0.2, 1e-14);
  EXPECT_THAT(f.advice, HasSubstr("from 1 to 0.8"));
  EXPECT_THAT(f.advice, HasSubstr("2 such places"));
}

TEST(Follow, ASwitchWithoutContinueSteps) {
  FollowTable next = new_7_9();
  next.segments[0].type = PtType::normal;
  next.loops = 0;
  const Report report = check(FollowSpec{{bridge_7_9(), next}});
  const Finding* f = found(report, "follow/switch_step");
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(f->where, 60000);
  EXPECT_NEAR(f->value, 0.6, 1e-14);
  EXPECT_THAT(f->advice, HasSubstr("let table 2 begin with a continue segment"));
}

TEST(Follow, PassesOfAContinuedTableThatIsNotPeriodicAreFoundOut) {
  // One continued segment of mean 0.4: 0, 0.8, 0, 0.8 ... alternates.
  const FollowSpec alternating{{{{{100, 40, PtType::continued}}, 0}}};
  const Finding* f = nullptr;
  const Report warned = check(alternating);
  ASSERT_NE(f = found(warned, "follow/wrap_ratio"), nullptr);
  EXPECT_FALSE(f->broken);
  EXPECT_EQ(follow(alternating).cam.segments().size(), 2U) << "both passes are shown";
  EXPECT_EQ(follow(alternating).cam.outside(), Extrapolation::refuse);
  // Two: the end is 2 (0.5 - 0.4) above the start: 0, 0.2, 0.4, ... grows.
  const FollowSpec growing{{{{{100, 40, PtType::continued}, {200, 90}}, 0}}};
  const Report broken = check(growing);
  ASSERT_NE(f = found(broken, "follow/wrap_ratio"), nullptr);
  EXPECT_TRUE(f->broken);
  EXPECT_NEAR(f->value, 0.6, 1e-14);
  // An even segment forgets: the passes agree from the second on.
  const FollowSpec settles{{{{{100, 80, PtType::continued}, {200, 140, PtType::even}}, 0}}};
  EXPECT_EQ(found(check(settles), "follow/wrap_ratio"), nullptr);
}

TEST(Follow, FiniteLoopsTakeTheRatioOfThePassBefore) {
  FollowTable table = new_7_9();
  table.loops = 3;
  const FollowSpec spec{{bridge_7_9(), table}};
  const SyncCam slave = follow(spec);
  EXPECT_EQ(slave.cam.segments().size(), 12U);
  EXPECT_EQ(slave.cam.at(slave.cam.end()).position, 46000 + 3 * 52000);
  EXPECT_NEAR(largest_jump(with(slave.cam, Extrapolation::refuse), 1).step, 0, 1e-14);
  EXPECT_EQ(slave.segments[3], "table 2 continue to 80000");
}

TEST(Follow, RejectsInputThatCannotBePlayed) {
  const auto text = [](const FollowSpec& spec) -> std::string {
    return test::error_of([&] { (void)follow(spec); });
  };
  EXPECT_EQ(text({}), "table: is missing: give at least one");
  EXPECT_EQ(text({{{{{100, 50}, {100, 60}}}}}),
            "segment[2].master = 100: must be greater than 100, the previous point");
  EXPECT_EQ(text({{example_7_8(), {{{100, NAN}}}}}),
            "table[2].segment[1].slave = nan: must be a finite number");
  EXPECT_THAT(text({{example_7_7(), example_7_7()}}), HasSubstr("table[1].loops = 0: is endless"));
  FollowTable many = example_7_7();
  many.loops = 1'000'000;
  EXPECT_THAT(text({{many}}), HasSubstr("more than 1e6 segments"));
  EXPECT_EQ(text({{example_7_7()}, NAN}), "start_ratio = nan: must be a finite number");
}

/// Each pass added up by the rules of the manual, without any of our code.
TEST(Follow, RandomTablesKeepTheManualsRules) {
  test::Random random(7601);
  for (int n = 0; n < 400 && !::testing::Test::HasFailure(); ++n) {
    FollowSpec spec{{}, random.below(2) == 0 ? 0 : random.uniform(-2, 2)};
    const int tables = 1 + random.below(3);
    for (int t = 0; t < tables; ++t) {
      FollowTable table;
      table.loops = 1 + random.below(3);
      double x = 0;
      for (int i = 0, size = 1 + random.below(6); i < size; ++i)
        table.segments.push_back({x += 1 + random.below(1000), random.uniform(-500, 500),
                                  static_cast<PtType>(random.below(4))});
      spec.tables.push_back(table);
    }
    SCOPED_TRACE("spec " + std::to_string(n));
    const Cam cam = follow(spec).cam;
    const auto made = follow_ratios(spec);
    double ratio = spec.start_ratio;
    double master = 0;
    double slave = 0;
    std::size_t k = 0;
    for (const FollowTable& table : spec.tables)
      for (int pass = 0; pass < table.loops; ++pass) {
        const double m0 = master;
        const double s0 = slave;
        for (std::size_t i = 0; i < table.segments.size(); ++i, ++k) {
          const auto& [x, s, type] = table.segments[i];
          const double mean = (s0 + s - slave) / (m0 + x - master);
          double start = ratio;
          if (type == PtType::normal && i == 0) start = 0;
          if (type == PtType::even) start = mean;
          if (type == PtType::stop) start = 2 * mean;
          const double tolerance = 1e-9 * (1 + std::abs(start) + std::abs(mean));
          ratio = 2 * mean - start;
          EXPECT_NEAR(made[k].start, start, tolerance);
          EXPECT_NEAR(made[k].end, ratio, tolerance);
          EXPECT_NEAR(cam.jet(master, Side::right)[1], start, tolerance);
          master = m0 + x;
          slave = s0 + s;
          EXPECT_NEAR(cam.jet(master, Side::left)[1], ratio, tolerance);
          EXPECT_NEAR(cam.jet(master)[0], slave, 1e-10);
        }
      }
    EXPECT_EQ(k, made.size());
  }
}

}  // namespace
}  // namespace jounce::follow_test
