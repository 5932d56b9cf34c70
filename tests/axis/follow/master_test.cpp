// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/master.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"
#include "support/random.hpp"

namespace jounce::master_test {
namespace {

using namespace test;
using test::Random;

double normal(Random& random) {
  const double u = 1 - random.uniform(0, 1);
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * random.uniform(0, 1));
}

constexpr double h = 1e-3;

/// Variances of the errors of position and velocity, by the recursion P = (I - K H) F P F' (I - K H)'
/// + K s^2 K' iterated to its end: matrices, and gains by their own formulas.
std::array<double, 2> variances(int order, double time_constant, double sigma) {
  const double t = std::exp(-h / time_constant);
  const double A = order == 2 ? 1 - t * t : 1 - t * t * t;
  const double B = order == 2 ? (1 - t) * (1 - t) : 1.5 * (1 - t) * (1 - t) * (1 + t);
  const double C = order == 2 ? 0 : std::pow(1 - t, 3) / 2;
  const std::array<double, 3> K{A, B / h, 2 * C / (h * h)};
  const double F[3][3] = {{1, h, h * h / 2}, {0, 1, h}, {0, 0, 1}};
  double M[3][3];  // (I - K H) F
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) M[i][j] = F[i][j] - K[i] * F[0][j];
  double P[3][3] = {};
  for (int n = 0; n < 20000; ++n) {
    double next[3][3] = {};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        next[i][j] = K[i] * K[j] * sigma * sigma;
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < 3; ++l) next[i][j] += M[i][k] * P[k][l] * M[j][l];
      }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) P[i][j] = next[i][j];
  }
  return {P[0][0], P[1][1]};
}

TEST(Estimate, HasTheNoiseThatTheoryGivesIt) {
  const double sigma = 10e-6;  // m
  for (const int order : {2, 3})
    for (const double time_constant : {2e-3, 5e-3, 20e-3}) {
      TrackerSpec spec{
          .velocity = 10, .acceleration = 100, .time_constant = time_constant, .order = order};
      Random random(7);
      Estimate e;
      double x2 = 0;
      double v2 = 0;
      const int samples = 200000;
      for (int i = 0; i < samples + 1000; ++i) {
        e = corrected(e, spec, i * h, 2.0 * (i * h) + sigma * normal(random));
        if (i < 1000) continue;
        x2 += std::pow(e.x - 2.0 * (i * h), 2) / samples;
        v2 += std::pow(e.v - 2.0, 2) / samples;
      }
      const auto [x_var, v_var] = variances(order, time_constant, sigma);
      EXPECT_NEAR(x2 / x_var, 1, 0.05) << order << " " << time_constant;
      EXPECT_NEAR(v2 / v_var, 1, 0.05) << order << " " << time_constant;
    }
}

// The residual r of order 2 settles where B r / h = a h compensates the acceleration in each step.
TEST(Estimate, LagsUnderAccelerationAsItsGainsPredict) {
  const double a = 20;
  TrackerSpec spec{.velocity = 100, .acceleration = 100, .time_constant = 5e-3, .order = 2};
  const auto settled = [&] {
    Estimate e;
    for (int i = 0; i <= 1000; ++i) e = corrected(e, spec, i * h, a * std::pow(i * h, 2) / 2);
    return e;
  };
  const double t = std::exp(-h / spec.time_constant);
  const double A = 1 - t * t;
  const double B = (1 - t) * (1 - t);
  const double r = a * h * h / B;
  Estimate e = settled();
  EXPECT_NEAR(a / 2 - e.x, (1 - A) * r, 1e-12);
  EXPECT_NEAR(a - e.v, A * r / h - a * h / 2, 1e-10);
  spec.order = 3;
  e = settled();
  EXPECT_NEAR(e.x, a / 2, 1e-12) << "a parabola is followed exactly";
  EXPECT_NEAR(e.v, a, 1e-9);
  EXPECT_NEAR(e.a, a, 1e-6);
}

TEST(Estimate, OfTheFirstMeasurementsIsTheirLeastSquaresLine) {
  TrackerSpec spec{.velocity = 100, .acceleration = 100, .time_constant = 1, .order = 2};
  const std::array z{0.0, 3.0, 1.0, 2.0};
  Estimate e;
  for (std::size_t i = 0; i < z.size(); ++i) e = corrected(e, spec, static_cast<double>(i), z[i]);
  // A time constant of one step fades the memory from the third step on; a long one keeps the line.
  spec.time_constant = 1e3;
  e = {};
  for (std::size_t i = 0; i < z.size(); ++i) e = corrected(e, spec, static_cast<double>(i), z[i]);
  EXPECT_NEAR(e.v, 0.4, 1e-12);        // sum (i - 1.5) (z - 1.5) / 5
  EXPECT_NEAR(e.x, 1.5 + 0.6, 1e-12);  // at i = 3
}

const TrackerSpec line{.velocity = 3, .acceleration = 20, .time_constant = 5e-3, .order = 2};

/// The output never breaks its own limits, and its derivatives agree.
struct Watch {
  Jet last{NAN, 0, 0, 0};
  double time = 0;
  int finite = 0;

  void see(const Jet& now, double t, const TrackerSpec& spec) {
    const double dt = t - time;
    if (std::isfinite(now[0])) {
      ++finite;
      ASSERT_TRUE(std::isfinite(now[1]) && std::isfinite(now[2])) << t;
      ASSERT_LE(std::abs(now[1]), spec.velocity) << t;
      if (std::isfinite(last[0])) {
        ASSERT_LE(std::abs(now[1] - last[1]), spec.acceleration * dt * (1 + 1e-9)) << t;
        ASSERT_NEAR(now[0] - last[0], dt * (now[1] + last[1]) / 2, 1e-12 * (1 + std::abs(now[0])));
      }
    } else {
      ASSERT_TRUE(std::isnan(now[0])) << "a lost master is NaN, never infinity";
    }
    last = now;
    time = t;
  }
};

TEST(Tracked, KeepsItsLimitsWhateverIsMeasured) {
  int finite = 0;
  for (std::uint64_t seed = 1; seed <= 100 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    TrackerSpec spec = line;
    spec.order = 2 + random.below(2);
    spec.time_constant = random.log_uniform(1e-3, 0.1);
    spec.settle = random.log_uniform(1e-4, 0.1);
    spec.latency = random.uniform(0, 5e-3);
    Tracked master(spec);
    Watch watch;
    double t = 0;
    double x = 0;
    for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) {
      t += h * (1 + (random.below(50) == 0 ? random.below(200) : 0));
      x += random.uniform(-5e-3, 5e-3);
      switch (random.below(40)) {
        case 0:
          x += random.uniform(-10, 10);
          break;
        case 1:
          master.see(t, random.below(2) == 0 ? NAN : INFINITY);
          break;
        case 2:
          master.see(NAN, x);
          break;
        case 3:
          master.lose();
          break;
        case 4:
          master.see(t - random.uniform(0, 0.05), x);
          break;
        case 5:
          master.see(t, random.uniform(-1, 1) * 1e300);
          break;
        default:
          if (random.below(3) > 0) master.see(t, x + random.uniform(-1e-3, 1e-3));
      }
      watch.see(master.at(t), t, spec);
    }
    finite += watch.finite;
  }
  EXPECT_GT(finite, 100000) << "it was hardly ever there: the test shows nothing";
}

TEST(Tracked, IsLostWithinItsLimitAndComesBackWhereItIs) {
  Tracked master(line);
  EXPECT_TRUE(std::isnan(master.at(0)[0])) << "nothing was ever measured";
  double t = 0;
  for (; t < 0.5; t += h) {
    master.see(t, 1.5 * t);
    master.at(t);
  }
  const double last = t - h;
  for (; t <= last + line.longest_age; t += h)
    ASSERT_NEAR(master.at(t)[0], 1.5 * t, 1e-9) << "on its way for as long as the limit allows";
  EXPECT_TRUE(std::isnan(master.at(last + line.longest_age + h)[0]));
  t = 5;
  master.see(t, 100);
  EXPECT_TRUE(std::isnan(master.at(t)[0])) << "one measurement is no velocity";
  master.see(t + h, 100 + 1.5 * h);
  EXPECT_NEAR(master.at(t + h)[0], 100 + 1.5 * h, 1e-9);
}

// At 5 m/s with a limit of 3 m/s the output falls behind by 2 m/s t, and reaches jump = 3 m/s 0.1 s
// after 0.15 s.
TEST(Tracked, AMasterAboveItsVelocityIsLostBeyondTheJumpUntilItIsSlowAgain) {
  Tracked master(line);
  double truth = 0;
  double lost_from = NAN;
  int i = 0;
  for (; i < 400; ++i, truth += 5 * h) {
    master.see(i * h, truth);
    const Jet now = master.at(i * h);
    if (i > 2 && std::isnan(now[0]) && std::isnan(lost_from)) lost_from = i * h;
    if (!std::isnan(now[0])) {
      ASSERT_LE(std::abs(truth - now[0]), 0.3 + 5 * h) << i;
      ASSERT_TRUE(std::isnan(lost_from)) << "it stays lost";
    }
  }
  EXPECT_NEAR(lost_from, 0.15, 5 * h);
  EXPECT_GT(master.lag(), 0.3) << "reported while it is lost";
  for (; i < 1000; ++i, truth += 2 * h) {
    master.see(i * h, truth);
    (void)master.at(i * h);
  }
  EXPECT_NEAR(master.at(i * h)[0], truth, 1e-6) << "no register from before the loss";
  EXPECT_NEAR(master.lag(), 0, 1e-6);
}

TEST(Tracked, AMasterSlightlyAboveItsVelocityIsNotLostBeforeTheJump) {
  Tracked master(line);
  for (int i = 0; i < 1000; ++i) {  // 3.1 m/s for 1 s: 0.1 m behind
    master.see(i * h, 3.1 * i * h);
    const Jet now = master.at(i * h);
    ASSERT_TRUE(i < 2 || !std::isnan(now[0])) << i;
  }
  EXPECT_NEAR(master.lag(), 0.1, 2e-3);
}

TEST(Tracked, ShortSilenceIsMadeUpWithinTheLimits) {
  Tracked master(line);
  Watch watch;
  const auto truth = [](double t) {  // brakes from 2 m/s at 10 m/s^2 during the silence
    const double s = std::clamp(t - 0.51, 0.0, 0.1);
    return 2 * std::min(t, 0.51) + 2 * s - 5 * s * s + 1.0 * std::max(t - 0.61, 0.0);
  };
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * h;
    if (i < 510 || i > 590) master.see(t, truth(t));
    const Jet now = master.at(t);
    watch.see(now, t, line);
    if (i > 2) {
      ASSERT_TRUE(std::isfinite(now[0])) << t;
    }
  }
  EXPECT_NEAR(watch.last[0], truth(1), 1e-6);
  EXPECT_NEAR(watch.last[1], 1, 1e-4);
}

TEST(Tracked, AJumpOfTheMasterIsALossForACycle) {
  Tracked master(line);
  for (int i = 0; i < 100; ++i) {
    master.see(i * h, i * h);
    master.at(i * h);
  }
  master.see(100 * h, 50 + 100 * h);
  EXPECT_TRUE(std::isnan(master.at(100 * h)[0]));
  master.see(101 * h, 50 + 101 * h);
  EXPECT_NEAR(master.at(101 * h)[0], 50 + 101 * h, 1e-12);
}

/// 4000 counts a turn of 0.2 m are 50 um a count, 14.4 um rms; with 5 um of noise 15.3 um.
std::array<double, 2> encoder_errors(int order, double velocity) {
  const double count = 50e-6;
  EncoderMaster master({.velocity = 3, .acceleration = 20, .time_constant = 10e-3, .order = order});
  Random random(3);
  double x2 = 0;
  double v2 = 0;
  for (int i = 0; i < 20000; ++i) {
    const double truth = velocity * (i * h);
    master.read(i * h, std::floor((truth + 5e-6 * normal(random)) / count + 0.5) * count);
    const Jet x = master.at(i * h);
    if (i < 500) continue;
    x2 += std::pow(x[0] - truth, 2) / 19500;
    v2 += std::pow(x[1] - velocity, 2) / 19500;
  }
  return {std::sqrt(x2), std::sqrt(v2)};
}

// A single-turn encoder of 4096 counts, forwards and backwards through many turns, against the same
// encoder with a counter of its turns.
TEST(EncoderMaster, CountsTheTurnsOfAModuloEncoder) {
  const TrackerSpec counted{.velocity = 3e6, .acceleration = 1e8, .order = 3};
  TrackerSpec repeats = counted;
  repeats.modulo = 4096;
  EncoderMaster whole(counted);
  EncoderMaster wraps(repeats);
  for (int k = 0; k < 5000; ++k) {
    const double t = k * h;
    const double counts = std::floor(1e6 * std::sin(t)) + 100;  // up to 1000 counts in a cycle
    whole.read(t, counts);
    wraps.read(t, counts - 4096 * std::floor(counts / 4096));
    const Jet expected = whole.at(t);
    const Jet now = wraps.at(t);
    ASSERT_EQ(std::isnan(now[0]), std::isnan(expected[0])) << k;
    if (std::isnan(now[0])) continue;
    ASSERT_NEAR(now[0], expected[0], 1e-6) << k;
    ASSERT_NEAR(now[1], expected[1], 1e-3) << k;
  }
}

TEST(EncoderMaster, FiltersNoiseAndQuantisation) {
  for (const auto& [order, x_most, v_most] : {std::tuple{2, 6e-6, 1.2e-3}, {3, 8e-6, 3e-3}}) {
    const auto [x, v] = encoder_errors(order, 1.0123);  // 20.2 counts a cycle
    EXPECT_LT(x, x_most) << "of 15.3 um rms unfiltered";
    EXPECT_LT(v, v_most) << "of 21.6 mm/s rms by differences";
    // So near to 20 counts a cycle that the rounding hardly changes from one to the next: no filter
    // sees it. Half a count is the most.
    const auto [slow_x, slow_v] = encoder_errors(order, 1.00037);
    EXPECT_GT(slow_x, 10e-6);
    EXPECT_LT(slow_x, 15.3e-6);
    EXPECT_LT(slow_v, 3e-3);
  }
}

TEST(EncoderMaster, ReadsThePositionInEachCycleAndReportsItsAge) {
  double truth = 0;
  EncoderMaster master({.velocity = 3, .acceleration = 20, .time_constant = 10e-3, .order = 2},
                       [&] { return truth; });
  EXPECT_TRUE(std::isnan(master.age(0)));
  for (int i = 0; i < 1000; ++i) {
    truth = 1.5 * (i * h);
    const Jet x = master.at(i * h);
    EXPECT_EQ(master.age(i * h), 0);
    if (i > 500) {
      EXPECT_NEAR(x[0], truth, 1e-9);
    }
  }
  truth = NAN;  // its drive has failed
  int there = 0;
  for (int i = 1000; i < 1300; ++i) there += !std::isnan(master.at(i * h)[0]);
  EXPECT_NEAR(there, 100, 1) << "extrapolated for longest_age, then lost";
  EXPECT_NEAR(master.age(1299 * h), 300 * h, 1e-12);
}

// The sender's clock is 1234.5 s ahead and 50 ppm fast; samples every 5 ms take 0.5 ms and an
// exponential of 1 ms in the mean, overtake each other, and one in ten is lost.
TEST(ExternalMaster, IsWhereItIsByOurClock) {
  ExternalMaster master({.velocity = 3,
                         .acceleration = 20,
                         .time_constant = 30e-3,
                         .order = 2,
                         .settle = 20e-3,
                         .latency = 0.5e-3});
  Random random(11);
  const auto truth = [](double t) { return 1.2 * t; };
  std::vector<MasterSample> under_way;
  Watch watch;
  double worst = 0;
  for (int i = 0; i < 40000; ++i) {
    const double t = i * h;
    if (i % 5 == 0 && random.below(10) > 0) {
      const double late = 0.5e-3 - 1e-3 * std::log(1 - random.uniform(0, 1));
      const auto stamp = static_cast<std::int64_t>((t * (1 + 50e-6) + 1234.5) * 1e9);
      under_way.push_back({stamp, 0, t + late, truth(t), true});
    }
    for (const MasterSample& s : under_way)
      if (s.received <= t) {
        ASSERT_TRUE(master.receive(s));
      }
    std::erase_if(under_way, [&](const MasterSample& s) { return s.received <= t; });
    const Jet x = master.at(t);
    watch.see(x, t, line);
    if (i > 2000) worst = std::max(worst, std::abs(x[0] - truth(t)));
  }
  EXPECT_GT(watch.finite, 39950);
  EXPECT_LT(worst, 1.2 * 0.4e-3)
      << "0.4 ms at 1.2 m/s: ten seconds of 50 ppm, and what is left of 1";
}

TEST(ExternalMaster, RestartsWithAnotherClockAndIsLostOnCommand) {
  ExternalMaster master(line);
  const auto send = [&](double t, std::int64_t stamp, std::int32_t clock, bool valid) {
    master.receive({stamp, clock, t, t, valid});
    return master.at(t);
  };
  for (int i = 0; i < 10; ++i) send(i * h, 5'000'000'000 + i * 1'000'000, 1, true);
  EXPECT_TRUE(std::isfinite(send(0.010, 5'010'000'000, 1, true)[0]));
  EXPECT_TRUE(std::isnan(send(0.011, 7, 2, true)[0])) << "another epoch";
  EXPECT_NEAR(send(0.012, 1'000'007, 2, true)[0], 0.012, 1e-9);
  EXPECT_TRUE(std::isnan(send(0.013, 2'000'007, 2, false)[0]));
  send(0.014, 3'000'007, 2, true);
  EXPECT_NEAR(send(0.015, 4'000'007, 2, true)[0], 0.015, 1e-9);
  EXPECT_TRUE(std::isnan(send(0.016, 9'000'000'000, 2, true)[0])) << "a clock that was set";
}

// Samples of an older time look like late ones: they are left out, so the master is lost within its
// limit. It is found again when the window holds no sample from before.
TEST(ExternalMaster, WhoseClockWasSetBackSilentlyIsLostForTheWindow) {
  ExternalMaster master(line);
  double lost_from = 0;
  double back_at = 0;
  for (std::int64_t i = 0; i < 20000; ++i) {
    const double t = static_cast<double>(i) * h;
    const std::int64_t set_back = i < 1000 ? 0 : 7'000'000'000;
    master.receive({i * 1'000'000 - set_back, 0, t, t, true});
    const bool lost = std::isnan(master.at(t)[0]);
    if (lost && i > 10 && lost_from == 0) lost_from = t;
    if (!lost && lost_from > 0 && back_at == 0) back_at = t;
  }
  EXPECT_NEAR(lost_from, 1 + line.longest_age, 2 * h);
  EXPECT_GT(back_at, lost_from);
  EXPECT_LT(back_at, 1 + ClockOffset{}.window + 0.1);
}

TEST(ClockOffset, TakesTheQuickestSampleAndNeverSteps) {
  Random random(5);
  ClockOffset clock;
  double before = 0;
  for (int i = 0; i < 60000; ++i) {
    const double t = i * h;
    const auto stamp = static_cast<std::int64_t>(t * 1e9);
    bool same = true;
    clock.local({stamp, 0, t + 1e-3 + 4e-3 * random.uniform(0, 1), 0, true}, same);
    if (i > 0) {
      ASSERT_LE(std::abs(clock.offset - before), 1e-3 * 6e-3);
    }
    before = clock.offset;
  }
  EXPECT_NEAR(clock.offset, 1e-3, 1e-5) << "the least time under way";
}

TEST(TableMaster, StandsBeforeAndAfterItsTable) {
  const TablePtr table = trapezoid_table(50, 10, 20, 20);
  TableMaster master(table, 3);
  EXPECT_EQ(master.at(1), (Jet{0, 0, 0, 0}));
  EXPECT_EQ(master.at(4), table->jet(1));
  EXPECT_EQ(master.at(100), (Jet{50, 0, 0, 0}));
  EXPECT_THROW(TableMaster{pmc600_cam()}, InputError);
}

TEST(TrackerSpec, RejectsValuesOutOfRange) {
  for (const double modulo : {-1.0, double(NAN), HUGE_VAL})
    EXPECT_THROW(Tracked({.velocity = 1, .acceleration = 1, .modulo = modulo}), InputError);
  const auto bad = [](auto change) {
    TrackerSpec spec = line;
    change(spec);
    return spec;
  };
  EXPECT_NO_THROW(Tracked{line});
  EXPECT_THROW(Tracked{TrackerSpec{}}, InputError) << "the master's limits are not guessed";
  EXPECT_THROW(Tracked{bad([](auto& s) { s.order = 4; })}, InputError);
  EXPECT_THROW(Tracked{bad([](auto& s) { s.time_constant = 0; })}, InputError);
  EXPECT_THROW(Tracked{bad([](auto& s) { s.longest_age = NAN; })}, InputError);
  EXPECT_THROW(Tracked{bad([](auto& s) { s.jump = -1; })}, InputError);
}

}  // namespace
}  // namespace jounce::master_test
