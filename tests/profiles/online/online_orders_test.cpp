// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "jounce/profiles/online/online.hpp"

#include "support/random.hpp"

// Random orders to three axes in every manner, also wrong ones: the setpoints are always those of
// one continuous motion under the widest limits that were ever set. JOUNCE_CASES sets the number of
// runs.

namespace jounce::online_orders_test {
namespace {

constexpr std::size_t n = 3;
constexpr double dt = 2e-3;
constexpr double most_a = 10;
constexpr double most_j = 100;

int cases(int usual) {
  const char* text = std::getenv("JOUNCE_CASES");
  return text ? std::atoi(text) : usual;
}

/// A magnitude up to `most`, sometimes 0.
double magnitude(test::Random& r, double most, bool may_be_zero) {
  return may_be_zero && r.below(8) == 0 ? 0 : r.log_uniform(0.05, 1) * most;
}

Bounds random_bounds(test::Random& r, bool zeros) {
  Bounds b =
      within(magnitude(r, 2, zeros), magnitude(r, most_a, zeros), magnitude(r, most_j, zeros));
  if (r.below(4) == 0) b.velocity_max = magnitude(r, 2, zeros);
  if (r.below(4) == 0) b.acceleration_min = -magnitude(r, most_a, false);
  if (r.below(4) == 0) b.jerk_max = magnitude(r, most_j, false);
  return b;
}

void order(test::Random& r, OnlineGenerator<n>& g) {
  const auto i = static_cast<std::size_t>(r.below(n));
  switch (r.below(10)) {
    case 0:
    case 1:
      g.set_target(i, {r.uniform(-3, 3), 0, 0});
      break;
    case 2:
      g.set_target(i, {r.uniform(-3, 3), r.uniform(-2.5, 2.5), r.uniform(-2, 2)});
      break;
    case 3:
      g.set_target(i, {r.uniform(-3, 3), r.uniform(-1, 1), 0}, MoveGoal::moving);
      break;
    case 4:
      g.set_velocity(i, r.uniform(-3, 3));
      break;
    case 5:
    case 6:
      g.set_bounds(i, random_bounds(r, true));
      break;
    case 7:
      g.set_enabled(i, r.below(2) == 0);
      break;
    case 8:
      g.set_sync(static_cast<Sync>(r.below(5)));
      break;
    default:
      g.set_grid(r.below(2) * dt);
      break;
  }
}

bool continues(const Motion& a, const Motion& b) {
  const double slack = 1e-9;
  const double dv = b.velocity - a.velocity - dt * (a.acceleration + b.acceleration) / 2;
  const double dx = b.position - a.position - dt * (a.velocity + b.velocity) / 2 +
                    dt * dt * (b.acceleration - a.acceleration) / 12;
  return std::abs(b.acceleration - a.acceleration) <= most_j * dt * (1 + slack) + slack &&
         std::abs(dv) <= most_j * dt * dt / 4 + slack &&
         std::abs(dx) <= most_j * dt * dt * dt / 8 + slack &&
         std::abs(b.acceleration) <= most_a * (1 + slack);
}

TEST(OnlineOrders, AnyOrdersMakeOneContinuousMotion) {
  int broken = 0;
  for (int run = 0; run < cases(300); ++run) {
    test::Random r(static_cast<std::uint64_t>(8000 + run));
    OnlineGenerator<n> g(static_cast<Sync>(r.below(5)));
    for (std::size_t i = 0; i < n; ++i) g.set_bounds(i, random_bounds(r, false));
    for (int k = 0; k < 1000 && broken < 5; ++k) {
      if (r.below(20) == 0) order(r, g);
      const std::array<Motion, n> before{g[0], g[1], g[2]};
      (void)g.step(dt);
      for (std::size_t i = 0; i < n; ++i)
        if (!continues(before[i], g[i])) {
          ++broken;
          ADD_FAILURE() << "run " << run << ", cycle " << k << ", axis " << i << ": x "
                        << before[i].position << " -> " << g[i].position << ", v "
                        << before[i].velocity << " -> " << g[i].velocity << ", a "
                        << before[i].acceleration << " -> " << g[i].acceleration;
        }
    }
  }
}

TEST(OnlineOrders, AfterAnyOrdersTheAxesGoWhereTheyAreSent) {
  int lost = 0;
  for (int run = 0; run < cases(300); ++run) {
    test::Random r(static_cast<std::uint64_t>(9000 + run));
    OnlineGenerator<n> g(Sync::time);
    for (std::size_t i = 0; i < n; ++i) g.set_bounds(i, random_bounds(r, false));
    for (int k = 0; k < 400; ++k) {
      if (r.below(10) == 0) order(r, g);
      (void)g.step(dt);
    }
    g.set_sync(Sync::time);
    for (std::size_t i = 0; i < n; ++i) {
      g.set_enabled(i, true);
      g.set_bounds(i, within(2, 5, 50));
      g.set_target(i, {.position = static_cast<double>(i)});
    }
    bool arrived = false;
    for (int k = 0; k < 20000 && !arrived; ++k) arrived = g.step(dt).arrived;
    const bool there = arrived && g[0].position == 0 && g[1].position == 1 && g[2].position == 2;
    if (!there && ++lost < 5)
      ADD_FAILURE() << "run " << run << ": " << g[0].position << ", " << g[1].position << ", "
                    << g[2].position << ", statuses " << explain(g.status(0)) << ", "
                    << explain(g.status(1)) << ", " << explain(g.status(2));
  }
}

}  // namespace
}  // namespace jounce::online_orders_test
