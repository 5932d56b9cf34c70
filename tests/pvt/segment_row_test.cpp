// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/segment_row.hpp"

#include <cmath>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "jounce/pvt/segment_fifos.hpp"

#include "support/random.hpp"

namespace jounce::segment_row_test {
namespace {

/// Every place asked for, by rows one after another.
Jet played(const std::vector<SegmentRow>& rows, RowStart from, double x) {
  double rate = 0;
  for (const SegmentRow& row : rows) {
    if (x < row.x_end || &row == &rows.back()) return point(row, from, rate, x);
    rate = rates(row, from, rate).end;
    from = {row.x_end, row.p_end};
  }
  return {};
}

TEST(SegmentRow, OfATableIsTheTableToTheBit) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    for (const Interpolation rule :
         {Interpolation::cubic_hermite, Interpolation::quintic_hermite}) {
      Columns c;
      double x = random.uniform(-5, 5);
      for (int i = 0; i < 20; ++i) {
        c.x.push_back(x += random.log_uniform(1e-3, 10));
        c.p.push_back(random.uniform(-100, 100));
        c.v.push_back(random.uniform(-10, 10));
        if (rule == Interpolation::quintic_hermite) c.a.push_back(random.uniform(-10, 10));
      }
      const Table table(Domain::time, rule, Extrapolation::hold, c);
      const auto rows = rows_of(table);
      ASSERT_EQ(rows.size(), 19U);
      EXPECT_TRUE(rows.back().last);
      for (int i = 0; i < 500; ++i) {
        const double at = random.uniform(table.start(), table.end());
        ASSERT_EQ(played(rows, start_of(table), at), table.jet(at)) << "at " << at;
      }
    }
  }
}

TEST(SegmentRow, OfALinearTableAgreesToOneRounding) {
  const Table table(Domain::time, Interpolation::linear, Extrapolation::hold,
                    {{0, 3, 10}, {0, 7, -2}, {}, {}});
  const auto rows = rows_of(table);
  for (double x = 0; x < 10; x += 0.0137) {
    const Jet row = played(rows, start_of(table), x);
    EXPECT_NEAR(row[0], table.jet(x)[0], 2e-15 * 7);
    EXPECT_NEAR(row[1], table.jet(x)[1], 1e-15);
  }
}

// x adds up exactly here: a curve keeps lengths, rows their ends.
TEST(SegmentRow, OfPtPointsIsPtToTheBit) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    std::vector<PtPoint> points;
    double x = 0;
    for (int i = 0; i < 12; ++i)
      points.push_back({x += 0x1p-10 * (1 + random.below(9999)), random.uniform(-50, 50),
                        static_cast<PtType>(random.below(4))});
    const auto rows = rows_of(points);
    const Trajectory whole = pt<OverTime>(points);
    for (int i = 0; i < 200; ++i) {
      const double at = random.uniform(0, x);
      ASSERT_EQ(played(rows, {}, at), whole.jet(at)) << "at " << at;
    }
  }
}

TEST(SegmentRow, PeaksAreThoseOfItsPolynomial) {
  // 3-4-5 over 2 s by 10 u: v = 1.875 h/T, a = 10/sqrt(3) h/T^2, j = 60 h/T^3
  const SegmentRow row{.x_end = 2, .p_end = 10, .v_start = 0, .v_end = 0, .degree = 5};
  const RowPeaks f = peaks(row, {}, 0);
  EXPECT_NEAR(f.velocity, 1.875 * 10 / 2, 1e-13);
  EXPECT_NEAR(f.acceleration, 10 / std::sqrt(3.0) * 10 / 4, 1e-13);
  EXPECT_NEAR(f.jerk, 60 * 10 / 8.0, 1e-12);
  EXPECT_EQ(f.velocity_step, 0);
  EXPECT_EQ(check(f, {.velocity = 9.38}), RowRule::none);
  EXPECT_EQ(check(f, {.velocity = 9.37}), RowRule::velocity);
  EXPECT_EQ(check(f, {.acceleration = 14.4}), RowRule::acceleration);
  EXPECT_EQ(check(f, {.jerk = 74}), RowRule::jerk);
  EXPECT_EQ(check(f, {.position_max = 9}), RowRule::position);
}

TEST(SegmentRow, WhatIsWrongHasAName) {
  const RowStart from{1, 0};
  const SegmentRow fine{.x_end = 2, .p_end = 1, .v_start = 0, .v_end = 0, .degree = 5};
  const auto with = [&](auto change) {
    SegmentRow row = fine;
    change(row);
    return check(row, from);
  };
  EXPECT_EQ(with([](SegmentRow&) {}), RowRule::none);
  EXPECT_EQ(with([](SegmentRow& r) { r.degree = 4; }), RowRule::no_degree);
  EXPECT_EQ(with([](SegmentRow& r) { r.x_end = 1; }), RowRule::not_ascending);
  EXPECT_EQ(with([](SegmentRow& r) { r.x_end = NAN; }), RowRule::not_finite);
  EXPECT_EQ(with([](SegmentRow& r) { r.p_end = INFINITY; }), RowRule::not_finite);
  EXPECT_EQ(with([](SegmentRow& r) { r.a_end = NAN; }), RowRule::not_finite);
  EXPECT_EQ(with([](SegmentRow& r) { r.a_end = NAN, r.degree = 3; }), RowRule::none);
  EXPECT_EQ(with([](SegmentRow& r) { r.v_end = NAN, r.degree = 3; }), RowRule::not_finite);
  EXPECT_EQ(with([](SegmentRow& r) { r.v_end = NAN, r.degree = 2; }), RowRule::none);
  EXPECT_EQ(with([](SegmentRow& r) { r.degree = 2; }), RowRule::rates_differ);
  EXPECT_EQ(with([](SegmentRow& r) { r.v_end = 2, r.degree = 2; }), RowRule::none);
  for (int i = 0; i <= static_cast<int>(RowRule::position); ++i) {
    EXPECT_NE(std::string(name(static_cast<RowRule>(i))), "");
    EXPECT_NE(std::string(explain(static_cast<RowRule>(i))), "");
  }
}

TEST(SegmentRow, IsEightNumbers) {
  const SegmentRow row{.x_end = 2, .p_end = 1, .v_end = 0, .degree = 2, .last = true};
  const auto c = columns_of(row);
  EXPECT_EQ(c[6], 2);
  const SegmentRow again = row_of(c);
  EXPECT_EQ(again.x_end, 2);
  EXPECT_TRUE(std::isnan(again.v_start));
  EXPECT_EQ(again.v_end, 0);
  EXPECT_EQ(again.degree, 2);
  EXPECT_TRUE(again.last);
  for (const double wrong : {0.0, 2.5, 6.0, 1e300, -1.0, std::nan("")}) {
    auto bad = c;
    bad[6] = wrong;
    EXPECT_EQ(check(row_of(bad), {}), RowRule::no_degree) << wrong;
  }
}

SegmentFifos::Layout rolling(std::size_t each, const RowLimits& limits = {}) {
  return {
      .each = each, .total = 2 * each, .stream = true, .open = true, .base = {}, .limits = limits};
}

TEST(SegmentFifos, AnOpenStreamStopsWhenItRunsDryAndContinues) {
  SegmentFifos fifos(4);
  fifos.reset(rolling(4));
  ASSERT_EQ(fifos.push(0, {.x_end = 1, .p_end = 1, .degree = 1}), RowRule::none);
  ASSERT_TRUE(fifos.start(0, 100, 50));
  EXPECT_EQ(fifos.at(100.5)[0], 50.5);
  EXPECT_EQ(fifos.known(), 101);
  EXPECT_TRUE(fifos.growing());
  EXPECT_EQ(fifos.at(102)[0], 51);
  EXPECT_EQ(fifos.state(), SegmentFifos::State::moving);
  ASSERT_EQ(fifos.push(0, {.x_end = 3, .p_end = 5, .degree = 1, .last = true}), RowRule::none);
  EXPECT_EQ(fifos.known(), 103);
  EXPECT_FALSE(fifos.growing());
  EXPECT_EQ(fifos.push(0, {.x_end = 4, .p_end = 5, .degree = 1}), RowRule::after_last);
  EXPECT_EQ(fifos.at(102)[0], 53);
  EXPECT_EQ(fifos.rows_played(), 1U);
  EXPECT_EQ(fifos.at(103)[0], 55);
  EXPECT_EQ(fifos.state(), SegmentFifos::State::cut_off) << "it ended at a rate";
  EXPECT_FALSE(fifos.start(0, 103, 55)) << "until it is cleared";
  ASSERT_TRUE(fifos.clear(0));
  EXPECT_FALSE(fifos.start(0, 103, 55)) << "it is empty";
}

TEST(SegmentFifos, RowsBeyondTheLimitsAreNotTaken) {
  SegmentFifos fifos(4);
  fifos.reset(rolling(4, {.velocity = 2, .velocity_step = 0.5}));
  EXPECT_EQ(fifos.push(0, {.x_end = 1, .p_end = 3, .degree = 1}), RowRule::velocity);
  EXPECT_EQ(fifos.push(0, {.x_end = 1, .p_end = 1, .degree = 1}), RowRule::velocity_step);
  EXPECT_EQ(fifos.push(0, {.x_end = 1, .p_end = 1, .v_start = 0}), RowRule::none) << "to rate 2";
  EXPECT_EQ(fifos.push(0, {.x_end = 2, .p_end = 3, .degree = 1}), RowRule::none);
  EXPECT_EQ(fifos.push(0, {.x_end = 3, .p_end = 3, .v_end = 0}), RowRule::velocity_step);
  EXPECT_EQ(fifos.size(0), 2U);
  EXPECT_EQ(fifos.peaks().velocity, 2);
  EXPECT_EQ(fifos.peaks().acceleration, 2);
}

TEST(SegmentFifos, WhatIsTakenIsNotCleared) {
  SegmentFifos fifos(4);
  fifos.reset({.each = 4, .total = 8});
  EXPECT_FALSE(fifos.take(0)) << "empty";
  ASSERT_EQ(fifos.push(0, {.x_end = 1, .p_end = 1}), RowRule::none);
  ASSERT_EQ(fifos.push(1, {.x_end = 1, .p_end = 1}), RowRule::none);
  ASSERT_TRUE(fifos.take(1));
  EXPECT_FALSE(fifos.take(0));
  EXPECT_FALSE(fifos.clear(1));
  EXPECT_TRUE(fifos.clear(0));
  fifos.give_back();
  EXPECT_TRUE(fifos.clear(1));
}

// The producer and the player in two threads: what is played is the whole path, wherever either of
// them happens to be. (The thread sanitizer runs this too.)
TEST(SegmentFifos, TwoThreadsLoseNothing) {
  constexpr int rows = 20000;
  const auto end = [](int i) { return std::sin(0.05 * i) * 100; };
  SegmentFifos fifos(16);
  fifos.reset(rolling(16));
  std::thread producer([&] {
    for (int i = 1; i <= rows; ++i) {
      const SegmentRow row{.x_end = 1.0 * i, .p_end = end(i), .degree = 1, .last = i == rows};
      while (fifos.push(0, row) == RowRule::full) std::this_thread::yield();
    }
  });
  while (!fifos.start(0, 0, 0)) std::this_thread::yield();
  double x = 0;
  while (fifos.moving()) {
    if (x + 0.25 > fifos.known()) {
      std::this_thread::yield();
      if (fifos.growing()) continue;
    }
    const Jet now = fifos.at(x += 0.25);
    const int i = static_cast<int>(std::floor(x));
    const double from = i == 0 ? 0 : end(i);
    const double expected = from + (end(i + 1) - from) * (x - i);
    if (fifos.moving()) {
      EXPECT_NEAR(now[0], expected, 1e-12) << x;
    }
  }
  producer.join();
  EXPECT_EQ(x, rows);
  EXPECT_EQ(fifos.rows_played(), static_cast<std::uint64_t>(rows));
}

}  // namespace
}  // namespace jounce::segment_row_test
