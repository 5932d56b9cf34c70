// SPDX-License-Identifier: Apache-2.0
// Plays a program of so many short lines to its end through an executor, at a simulated pace, and reports
// memory, the largest cycle time, and how far the ticks are from one plan of the whole program. It is no
// test of CI: a million lines take minutes.
//
//     long_program [LINES=1000000] [PACE=4] [deviation|average] [LENGTH=0.02]
//
// PACE: simulated seconds in one second. average: the corners are averaged, not rounded one by one.
// LENGTH: greatest length of a line, mm. 0.1 mm and more: no plan of the whole program is made at the end.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <set>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <sys/resource.h>

#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/group/plotter_site.hpp"

namespace jounce::test {
namespace {

using namespace std::chrono_literals;
using Wall = std::chrono::steady_clock;
constexpr double dt = 1e-3;
constexpr double deviation = 0.002;  // mm

double seconds_since(Wall::time_point start) {
  return std::chrono::duration<double>(Wall::now() - start).count();
}

double peak_mebibytes() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_maxrss) / 1024;
}

double angle = 2.5e-4;  // rad from one line to the next

std::array<double, 2> point(int k) {
  return {80 * std::sin(angle * k), 60 * std::sin(0.76 * angle * k)};
}

LimitedProgram lines(int count, Corner corner) {
  Program program(2);
  program.set({.velocity = 100, .corner = corner, .value = deviation});
  for (int k = 1; k <= count; ++k) program.line({point(k)[0], point(k)[1]}, k);
  return {std::move(program),
          {.axes = std::vector<Limits>(2, test::limits(200, 2000, 1e5))},
          {"x", "y"},
          {}};
}

/// The distance of a place from the lines near the line `near`, which it moves on.
double away_from_lines(const std::array<double, 2>& at, int& near, int count) {
  const auto distance = [&](int k) {
    const auto a = point(k);
    const auto b = point(k + 1);
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double t =
        std::clamp(((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(at[0] - a[0] - t * dx, at[1] - a[1] - t * dy);
  };
  int best = near;
  for (int k = near; k < std::min(best + 8, count); ++k)  // a turn soon after comes near, too
    if (distance(k) < distance(best)) best = k;
  near = best;
  return distance(best);
}

int play(int count, double pace, Corner corner) {
  PlotterSite site;
  site.advance(10ms);
  if (!site.order("plotter", command::Enable{}).ok()) return 1;
  const double before = peak_mebibytes();
  auto start = Wall::now();
  std::size_t bytes = 0;
  {
    const LimitedProgram program = lines(count, corner);
    StreamPlan plan = stream_of(program);
    bytes = plan.tables.front().table.size() * 2 * sizeof(double);
    const StreamOutcome outcome = site.stream(std::move(plan));
    if (!outcome.ok()) {
      std::printf("rejected: %s\n", outcome.reason.c_str());
      return 1;
    }
  }
  std::printf(
      "%d lines: sent, planned and begun in %.1f s; peak of memory %.0f MiB (%.0f before, the "
      "table has %.0f)\n",
      count, seconds_since(start), peak_mebibytes(), before, static_cast<double>(bytes) / 1048576);
  start = Wall::now();
  std::vector<std::array<double, 2>> places;
  const bool compares = angle <= 1e-3;
  std::vector<double> cycles;
  std::set<std::uint64_t> movements;
  const AxisConfig axis = resolved(Plotter::config(test::limits(200, 2000, 1e5)));
  std::array<Tick, 2> was{site.last(0), site.last(1)};
  int broken = 0;
  int near = 0;
  double away = 0;
  const std::uint64_t finished = site.last(Plotter::group).finished;
  while (site.last(Plotter::group).finished < finished + 100 && seconds_since(start) < 1500) {
    const auto begun = Wall::now();
    site.cycle.once();
    cycles.push_back(seconds_since(begun));
    site.dispatcher.turn(0ns);
    const Tick& group = site.last(Plotter::group);
    for (const std::size_t i : {0U, 1U}) {
      if (site.last(i).tick == was[i].tick) continue;
      broken += !keeps_limits(axis, was[i], site.last(i), true);
      was[i] = site.last(i);
    }
    const std::array<double, 2> at{site.last(0).position, site.last(1).position};
    if (group.job == 0 && std::hypot(at[0] - point(count)[0], at[1] - point(count)[1]) < 1e-9)
      break;
    movements.insert(group.job);
    if (compares) places.push_back(at);
    away = std::max(away, away_from_lines(at, near, count));
    const double ahead = static_cast<double>(cycles.size()) * dt / pace - seconds_since(start);
    if (ahead > 0.01) std::this_thread::sleep_for(std::chrono::duration<double>(ahead));
  }
  std::sort(cycles.begin(), cycles.end());
  const auto share = [&](double part) {
    return 1e6 * cycles[static_cast<std::size_t>(part * static_cast<double>(cycles.size() - 1))];
  };
  std::printf(
      "played in %.1f s: %zu ticks, %zu plans, %llu motions; cycle %.1f us median, %.1f us at "
      "99.9 %%, %.0f us at most\n",
      seconds_since(start), cycles.size(), movements.size() - movements.count(0),
      static_cast<unsigned long long>(site.last(Plotter::group).finished - finished), share(0.5),
      share(0.999), share(1));
  std::printf(
      "ticks beyond a limit: %d; at most %.3g mm from the lines (%.3g permitted); fault %d; peak "
      "of memory %.0f MiB\n",
      broken, away, deviation, static_cast<int>(site.last(Plotter::group).fault), peak_mebibytes());
  const bool kept = broken == 0 && away <= deviation * (1 + 1e-9);
  if (!compares) return kept ? 0 : 1;
  const LimitedProgram program = lines(count, corner);
  const auto whole =
      planned_program(program.program, program.limits, *site.axes[Plotter::group].group);
  std::array<Motion, 2> motion;
  PlanCursor cursor(*whole->plan);
  double from_plan = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    cursor.at(std::min(static_cast<double>(k) * dt, whole->plan->duration()), motion);
    for (std::size_t i = 0; i < 2; ++i)
      from_plan = std::max(from_plan, std::abs(places[k][i] - motion[i].position));
  }
  std::printf(
      "one plan of all commands takes %.3f s, and the ticks %.3f s; they are at most %.3g mm "
      "apart; peak of memory with this plan %.0f MiB\n",
      whole->plan->duration(), static_cast<double>(places.size()) * dt, from_plan,
      peak_mebibytes());
  return kept ? 0 : 1;
}

}  // namespace
}  // namespace jounce::test

int main(int argc, char** argv) {
  try {
    if (argc > 4) jounce::test::angle = std::atof(argv[4]) / 80;
    return jounce::test::play(
        argc > 1 ? std::atoi(argv[1]) : 1'000'000, argc > 2 ? std::atof(argv[2]) : 4,
        argc > 3 && argv[3] == std::string_view("average") ? jounce::Corner::average
                                                           : jounce::Corner::deviation);
  } catch (const jounce::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
