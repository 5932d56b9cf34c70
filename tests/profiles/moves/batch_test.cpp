// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/batch.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/moves/move.hpp"

#include "profiles/src/moves/batch_kernel.hpp"
#include "support/random.hpp"

namespace jounce::batch_test {
namespace {

struct Moves {
  std::vector<double> distance, entry, exit, velocity, acceleration, jerk, duration, peak;

  explicit Moves(std::size_t n)
      : distance(n),
        entry(n),
        exit(n),
        velocity(n),
        acceleration(n),
        jerk(n),
        duration(n),
        peak(n) {}
  [[nodiscard]] MoveColumns columns() const {
    return {distance, entry, exit, velocity, acceleration, jerk};
  }
  [[nodiscard]] ::testing::Message show(std::size_t i) const {
    return ::testing::Message() << distance[i] << ' ' << entry[i] << ' ' << exit[i] << ' '
                                << velocity[i] << ' ' << acceleration[i] << ' ' << jerk[i];
  }
};

Moves random_moves(std::size_t n, std::uint64_t seed, double decades) {
  test::Random random(seed);
  const double lo = std::pow(10, -decades);
  const double hi = std::pow(10, decades);
  const auto either = [&] { return (random.below(2) == 0 ? 1 : -1) * random.log_uniform(lo, hi); };
  Moves m(n);
  for (std::size_t i = 0; i < n; ++i) {
    m.distance[i] = either();
    m.entry[i] = random.below(5) == 0 ? 0 : either();
    m.exit[i] = random.below(5) == 0 ? 0 : either();
    m.velocity[i] =
        std::max(std::abs(m.entry[i]), std::abs(m.exit[i])) + random.log_uniform(lo, hi);
    m.acceleration[i] = random.log_uniform(lo, hi);
    m.jerk[i] = random.log_uniform(lo, hi);
  }
  return m;
}

TEST(Batch, IsTheSolversAnswerForEveryMove) {
  for (const double decades : {1.0, 3.0}) {
    Moves m = random_moves(50000, 41, decades);
    minimum_durations(m.columns(), m.duration, m.peak);
    for (std::size_t i = 0; i < m.duration.size() && !::testing::Test::HasFailure(); ++i) {
      SCOPED_TRACE(m.show(i));
      const MoveResult one = move_to({0, m.entry[i], 0}, {m.distance[i], m.exit[i], 0},
                                     within(m.velocity[i], m.acceleration[i], m.jerk[i]));
      ASSERT_TRUE(one);
      EXPECT_NEAR(m.duration[i], one.profile.duration(), 1e-12 * m.duration[i]);
    }
  }
}

TEST(Batch, KernelsOfAllWidthsAgree) {
  std::vector<const profiles_detail::Kernels*> all{&profiles_detail::kernels_anywhere};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    all.push_back(&profiles_detail::kernels_avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    all.push_back(&profiles_detail::kernels_avx512);
#endif
  const Moves m = random_moves(64 * 500, 42, 2);
  std::size_t unsettled = 0;
  for (std::size_t first = 0; first < m.distance.size(); first += 64) {
    std::vector<profiles_detail::Block> answers(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      profiles_detail::Block& b = answers[k];
      for (std::size_t i = 0; i < 64; ++i) {
        b.distance[i] = m.distance[first + i];
        b.entry[i] = m.entry[first + i];
        b.exit[i] = m.exit[first + i];
        b.velocity[i] = m.velocity[first + i];
        b.acceleration[i] = m.acceleration[first + i];
        b.jerk[i] = m.jerk[first + i];
      }
      all[k]->ways(b);
    }
    for (std::size_t i = 0; i < 64; ++i) {
      if (!(answers[0].settled[i] > 0)) ++unsettled;
      for (const profiles_detail::Block& b : answers)
        if (b.settled[i] > 0 && answers[0].settled[i] > 0) {
          EXPECT_NEAR(b.duration[i], answers[0].duration[i], 1e-12 * b.duration[i])
              << m.show(first + i);
        }
    }
    if (HasFailure()) break;
  }
  EXPECT_LT(unsettled, m.distance.size() / 50) << "the scalar way should be the exception";
}

TEST(Batch, RestToRestIsTheQuerysAnswer) {
  Moves m = random_moves(20001, 43, 3);  // not a whole number of blocks
  for (std::size_t i = 0; i < m.velocity.size(); i += 7)
    m.velocity[i] = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < m.velocity.size(); i += 5)
    m.jerk[i] = std::numeric_limits<double>::infinity();
  minimum_durations({.distance = m.distance,
                     .velocity = m.velocity,
                     .acceleration = m.acceleration,
                     .jerk = m.jerk},
                    m.duration, m.peak);
  for (std::size_t i = 0; i < m.duration.size() && !HasFailure(); ++i) {
    SCOPED_TRACE(m.show(i));
    const double h = std::abs(m.distance[i]);
    const SpanEnds ends{.velocity = m.velocity[i]};
    const Ramp ramp{m.acceleration[i], m.jerk[i]};
    EXPECT_NEAR(m.duration[i], minimum_duration(h, ends, ramp).value(), 4e-15 * m.duration[i]);
    EXPECT_NEAR(m.peak[i], std::copysign(peak_velocity(h, ends, ramp).value(), m.distance[i]),
                4e-15 * std::abs(m.peak[i]));
  }
}

TEST(Batch, OneValueStandsForAll) {
  const std::vector<double> way{1, -2, 3};
  const std::vector<double> entry{0.5};
  const std::vector<double> limit{2};
  std::vector<double> t(3);
  minimum_durations(
      {.distance = way, .entry = entry, .velocity = limit, .acceleration = limit, .jerk = limit},
      t);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(t[i], move_to({0, 0.5, 0}, {way[i]}, within(2, 2, 2)).profile.duration(), 1e-14);
}

TEST(Batch, ReturnsNanWithoutAMove) {
  Moves m = random_moves(16, 44, 1);
  const double nan = std::nan("");
  m.distance[0] = nan;
  m.entry[1] = 2 * m.velocity[1];
  m.velocity[2] = 0;
  m.acceleration[3] = -1;
  m.jerk[4] = nan;
  m.exit[5] = nan;
  m.distance[6] = std::numeric_limits<double>::infinity();
  m.acceleration[7] = std::numeric_limits<double>::infinity();
  m.acceleration[8] = 1e31;
  m.velocity[9] = 1e31;
  m.jerk[10] = 1e-31;
  m.jerk[11] = 1e31;
  m.distance[12] = -1e31;
  m.distance[13] = 5e-324;
  m.entry[14] = m.velocity[14] = 1e31;
  minimum_durations(m.columns(), m.duration);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_TRUE(std::isnan(m.duration[i])) << i;
  EXPECT_GT(m.duration[15], 0);
  auto rests = m.columns();
  rests.entry = rests.exit = {};
  minimum_durations(rests, m.duration);
  for (const std::size_t i : {0u, 2u, 3u, 4u, 6u, 7u, 8u, 9u, 10u, 11u, 12u, 13u, 14u})
    EXPECT_TRUE(std::isnan(m.duration[i])) << i;
  EXPECT_GT(m.duration[15], 0);
}

TEST(Batch, StayingAtRestTakesNoTime) {
  const std::vector<double> zero{0};
  const std::vector<double> one{1};
  std::vector<double> t{7};
  minimum_durations({.distance = zero, .velocity = one, .acceleration = one, .jerk = one}, t);
  EXPECT_EQ(t[0], 0);
}

TEST(Batch, DirectRampIsNotMissedByRounding) {
  // Both ways run backwards, where a hair's breadth more or less takes a turn.
  test::Random random(45);
  for (int i = 0; i < 1000 && !HasFailure(); ++i) {
    const Ramp ramp{random.log_uniform(1e-2, 1e2), random.log_uniform(1e-2, 1e2)};
    const double v0 = (random.below(2) == 0 ? 1 : -1) * random.log_uniform(1e-2, 1e2);
    const double v1 = std::copysign(random.log_uniform(1e-2, 1e2), v0);
    const Extent direct = ramp_between(v0, v1, ramp).value();
    const std::vector<double> way{direct.distance}, entry{v0}, exit{v1}, limit{1e3};
    const std::vector<double> a{ramp.acceleration}, j{ramp.jerk};
    std::vector<double> t(1);
    minimum_durations({way, entry, exit, limit, a, j}, t);
    EXPECT_NEAR(t[0], direct.duration, 1e-14 * t[0])
        << v0 << ' ' << v1 << ' ' << ramp.acceleration << ' ' << ramp.jerk;
  }
}

TEST(Batch, ColumnsOfAWrongSizeGiveNoDuration) {
  const std::vector<double> three{1, 2, 3};
  const std::vector<double> two{1, 2};
  const std::vector<double> one{1};
  std::vector<double> durations(3), peak(3), small(2);
  minimum_durations({.distance = three, .velocity = two, .acceleration = one, .jerk = one},
                    durations, peak);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(durations[i]) && std::isnan(peak[i]));
  minimum_durations({.distance = three, .velocity = one, .acceleration = one, .jerk = one},
                    durations, small);
  for (const double t : durations) EXPECT_TRUE(std::isnan(t));
  minimum_durations({.distance = three, .velocity = one, .acceleration = one, .jerk = one},
                    durations, peak);
  for (const double t : durations) EXPECT_GT(t, 0);
}

}  // namespace
}  // namespace jounce::batch_test
