// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/sequences/queue.hpp"

#include "support/random.hpp"

namespace jounce::queue_property_test {
namespace {

using test::Random;

// ---- what a failing test prints --------------------------------------------------------------------

std::string text(const MotionCommand& command) {
  if (const auto* c = std::get_if<MoveAbsolute>(&command))
    return "MoveAbsolute{" + number(c->position) + "}";
  if (const auto* c = std::get_if<MoveRelative>(&command))
    return "MoveRelative{" + number(c->distance) + "}";
  if (const auto* c = std::get_if<MoveVelocity>(&command))
    return "MoveVelocity{" + number(c->direction) + "}";
  if (const auto* c = std::get_if<Dwell>(&command)) return "Dwell{" + number(c->time) + "}";
  return "Halt{}";
}

std::string text(const QueueSpec& spec) {
  std::ostringstream out;
  out << "start {" << number(spec.start.position) << ", " << number(spec.start.velocity) << ", "
      << number(spec.start.acceleration) << "}\n";
  for (const QueuedCommand& c : spec.commands) {
    const Dynamics& d = c.dynamics;
    out << "{" << text(c.command) << ", {" << number(d.velocity) << ", " << number(d.acceleration)
        << ", " << number(d.deceleration) << ", " << number(d.jerk) << "}, BufferMode("
        << static_cast<int>(c.mode) << ")" << (c.issued ? ", " + number(*c.issued) : "") << "},\n";
  }
  return out.str();
}

// ---- random queues ---------------------------------------------------------------------------------

/// Gap between the halves of a profile's curve in the worst of a million moves.
constexpr double rounding = 1e-11;

struct Kind {
  double decades = 1;  ///< range of every number, either way
  bool jerk = true;
  bool aborts = false;
  bool rest = false;  ///< from rest, to positions: over many decades a velocity leads anywhere
};

Dynamics random_dynamics(Random& random, const Kind& kind) {
  const double lo = std::pow(10, -kind.decades);
  const double hi = 1 / lo;
  return {random.log_uniform(lo, hi), random.log_uniform(lo, hi),
          random.below(3) == 0 ? 0 : random.log_uniform(lo, hi),
          kind.jerk ? random.log_uniform(lo, hi) * 10 : 0, 0};
}

MotionCommand random_command(Random& random, const Kind& kind) {
  const double way = random.log_uniform(std::pow(10, -kind.decades), std::pow(10, kind.decades)) *
                     (random.below(5) == 0 ? -1 : 1);
  switch (kind.rest ? 2 + random.below(10) : random.below(12)) {
    case 0:
      return MoveVelocity{random.below(2) == 0 ? 1 : -1};
    case 1:
      return Halt{};
    case 2:
      return Dwell{random.uniform(0, 1)};
    case 3:
      return MoveAbsolute{way};
    case 4:
      return random.below(3) == 0 ? MoveRelative{0} : MoveRelative{way};
    default:
      return MoveRelative{way};
  }
}

QueueSpec random_queue(Random& random, const Kind& kind) {
  QueueSpec spec;
  const int n = 1 + random.below(12);
  double issued = 0;
  for (int i = 0; i < n; ++i) {
    QueuedCommand c{random_command(random, kind), random_dynamics(random, kind)};
    c.mode = static_cast<BufferMode>(1 + random.below(5));
    if (kind.aborts && i > 0 && random.below(3) == 0 && !std::holds_alternative<Dwell>(c.command)) {
      c.mode = BufferMode::aborting;
      c.issued = issued += random.log_uniform(0.03, 30);
    }
    spec.commands.push_back(c);
  }
  spec.commands.front().command = MoveRelative{1};
  if (!kind.rest && random.below(2) == 0)
    spec.start = {random.uniform(-1, 1), random.uniform(-3, 3),
                  kind.jerk ? random.uniform(-3, 3) : 0};
  return spec;
}

// ---- what holds of every queue ---------------------------------------------------------------------

bool begins_a_batch(const QueueSpec& spec, std::size_t i) {
  if (i == 0 || spec.commands[i].mode == BufferMode::aborting) return true;
  const MotionCommand& before = spec.commands[i - 1].command;
  if (std::holds_alternative<Dwell>(before)) return begins_a_batch(spec, i - 1);
  return std::holds_alternative<MoveVelocity>(before);
}

/// Index of a break among the segments.
std::size_t segment_at(const Trajectory& f, double time) {
  return static_cast<std::size_t>(std::lower_bound(f.breaks().begin(), f.breaks().end(), time) -
                                  f.breaks().begin());
}

/// Largest magnitudes while speeding up and while slowing down, over a dense sample.
struct Accelerations {
  double speeding = 0;
  double slowing = 0;
};

Accelerations accelerations(const Trajectory& f, std::size_t first, std::size_t last,
                            double still) {
  Accelerations most;
  for (std::size_t i = first; i < last; ++i)
    for (int n = 0; n <= 16; ++n) {
      const Jet j = evaluate(f.segments()[i], n / 16.0);
      if (std::abs(j[1]) < still) continue;
      double& kind = j[1] * j[2] > 0 ? most.speeding : most.slowing;
      kind = std::max(kind, std::abs(j[2]));
    }
  return most;
}

/// A short cruise joins two positions that are known to rounding.
double cruise_rounding(const Trajectory& f, std::size_t first, std::size_t last) {
  double most = 0;
  for (std::size_t i = first; i < last; ++i)
    if (const Segment& s = f.segments()[i]; s.degree == 1)
      most = std::max(most, 1e-15 * magnitude(s) / s.length);
  return most;
}

void expect_dynamics(const QueueSpec& spec, const QueuedMotion& m, std::size_t i) {
  const CommandRecord& r = m.commands[i];
  const Trajectory& f = m.trajectory;
  const std::size_t first = segment_at(f, r.begin);
  const std::size_t last = segment_at(f, r.end);
  if (first == last || std::holds_alternative<Dwell>(spec.commands[i].command)) return;
  const Ranges range = segment_extrema(f, first, last - 1);
  Dynamics d = spec.commands[i].dynamics;
  if (d.jerk == 0) d.jerk = Bounds::none;
  const Jet begin = evaluate(f.segments()[first], 0);
  const double settled = begin[1] + begin[2] * std::abs(begin[2]) / (2 * d.jerk);
  const double velocity = std::holds_alternative<Halt>(spec.commands[i].command) ? 0 : d.velocity;
  const double fastest =
      std::max({velocity, std::abs(begin[1]), std::abs(settled), std::abs(r.reached)});
  EXPECT_LE(std::abs(range[1].peak().value),
            fastest * (1 + rounding) + cruise_rounding(f, first, last));
  const double deceleration = d.deceleration == 0 ? d.acceleration : d.deceleration;
  const Accelerations a = accelerations(f, first, last, 1e-6 * fastest);
  const double steep = std::isfinite(d.jerk) ? std::abs(begin[2]) : 0;
  const double rate = std::max(d.acceleration, deceleration);
  EXPECT_LE(a.speeding, std::max(steep, d.acceleration) + rounding * rate);
  EXPECT_LE(a.slowing, std::max(steep, deceleration) + rounding * rate);
  EXPECT_LE(std::abs(range[3].peak().value), d.jerk * (1 + rounding));
}

void expect_target(const QueueSpec& spec, const QueuedMotion& m, std::size_t i) {
  const CommandRecord& r = m.commands[i];
  const Trajectory& f = m.trajectory;
  const double travel = std::abs(extrema(f, 0).peak().value);
  const double fastest = std::abs(extrema(f, 1).peak().value);
  if (const std::size_t last = segment_at(f, r.end); last > 0) {
    const Jet end = evaluate(f.segments()[last - 1], 1);
    if (r.state == CommandState::done) {
      EXPECT_NEAR(end[0], r.target, 4e-15 * travel + 4e-16 * r.end * fastest);
    }
    EXPECT_NEAR(end[1], r.reached, 1e-12 * fastest + cruise_rounding(f, last - 1, last));
  }
  const MotionCommand& command = spec.commands[i].command;
  const bool goes_to = std::holds_alternative<MoveRelative>(command) ||
                       std::holds_alternative<MoveAbsolute>(command);
  if (!goes_to || begins_a_batch(spec, i) || r.begin == r.end) return;
  const Ranges range = segment_extrema(f, segment_at(f, r.begin), segment_at(f, r.end) - 1);
  const double begin = f.at(r.begin).position;
  const double least = std::min(begin, r.target) - range[0].min.value;
  const double most = range[0].max.value - std::max(begin, r.target);
  EXPECT_LE(std::max(least, most), rounding * travel) << "overshoots";
  if (r.state == CommandState::done) {
    EXPECT_LE(std::abs(r.reached), std::abs(r.planned));
  }
}

void expect_queue(const QueueSpec& spec, const QueuedMotion& m, const Kind& kind) {
  EXPECT_TRUE(check_continuity(m.trajectory, kind.jerk ? 2 : 1).ok());
  double now = 0;
  for (std::size_t i = 0; i < m.commands.size(); ++i) {
    SCOPED_TRACE("command " + std::to_string(i + 1));
    EXPECT_GE(m.commands[i].begin, now);
    EXPECT_GE(m.commands[i].end, m.commands[i].begin);
    now = m.commands[i].begin;
    expect_dynamics(spec, m, i);
    expect_target(spec, m, i);
  }
}

void run(const Kind& kind, std::uint64_t seed, int cases) {
  Random random(seed);
  for (int i = 0; i < cases; ++i) {
    const QueueSpec spec = random_queue(random, kind);
    SCOPED_TRACE(text(spec));
    try {
      expect_queue(spec, queue(spec), kind);
    } catch (const InputError& e) {
      ADD_FAILURE() << e.what();
    }
    if (::testing::Test::HasFailure()) break;
  }
}

TEST(QueueProperty, EveryJerkLimitedQueueHolds) {
  run({1, true, false}, 1, 4000);
}
TEST(QueueProperty, EveryQueueOfSecondOrderHolds) {
  run({1, false, false}, 2, 4000);
}
TEST(QueueProperty, EveryAbortedQueueHolds) {
  run({1, true, true}, 3, 4000);
}
TEST(QueueProperty, EveryAbortedQueueOfSecondOrderHolds) {
  run({1, false, true}, 4, 4000);
}
TEST(QueueProperty, HoldsOverSixDecades) {
  run({3, true, false, true}, 5, 4000);
}

// ---- an independent look-ahead -----------------------------------------------------------------------
// From docs/generators/queue.md: "Buffer modes", and (2) and (3) of "Look-ahead". The distance of a velocity change is
// integrated over the points of its acceleration, and a search over points of velocity finds the highest that fits.

/// The distance of a velocity change without acceleration at either end.
double distance(double from, double to, double acceleration, double jerk) {
  const double change = std::abs(to - from);
  if (change == 0) return 0;
  const double peak = jerk == 0 ? acceleration : std::min(acceleration, std::sqrt(change * jerk));
  const double rise = jerk == 0 ? 0 : peak / jerk;
  const double sign = to < from ? -1 : 1;
  struct Point {
    double time, acceleration;
  };
  const std::vector<Point> points{
      {0, 0}, {rise, peak}, {change / peak, peak}, {change / peak + rise, 0}};
  double velocity = from;
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double time = points[i].time - points[i - 1].time;
    const double before = sign * points[i - 1].acceleration;
    const double after = sign * points[i].acceleration;
    const double middle = velocity + time * (3 * before + after) / 8;
    const double end = velocity + time * (before + after) / 2;
    sum += time * (velocity + 4 * middle + end) / 6;  // Simpson: exact for a quadratic
    velocity = end;
  }
  return sum;
}

/// The highest velocity that fits, among points from `low`, which fits, to `high`; then among points next to it.
template <class Fits>
double highest(double low, double high, const Fits& fits) {
  constexpr int points = 100;
  for (int digits = 0; digits < 12; digits += 2) {
    const double step = (high - low) / points;
    int best = points;
    while (best > 0 && !fits(best == points ? high : low + best * step)) --best;
    if (best == points) return high;
    high = low + (best + 1) * step;
    low += best * step;
  }
  return low;
}

/// Junction velocities of moves in one direction from rest to rest.
std::vector<double> looked_ahead(const QueueSpec& spec) {
  struct Point {
    double length;      ///< length of the move that ends here
    Dynamics dynamics;  ///< dynamics of this move
    double velocity = 0;
  };
  std::vector<Point> points;
  for (const QueuedCommand& c : spec.commands)
    points.push_back({std::get<MoveRelative>(c.command).distance, c.dynamics});
  for (std::size_t k = points.size() - 1; k-- > 0;) {
    Point& here = points[k];
    const Point& next = points[k + 1];
    const auto [low, high] = std::minmax(here.dynamics.velocity, next.dynamics.velocity);
    const std::map<BufferMode, double> planned{
        {BufferMode::buffered, 0},
        {BufferMode::blending_low, low},
        {BufferMode::blending_previous, here.dynamics.velocity},
        {BufferMode::blending_next, next.dynamics.velocity},
        {BufferMode::blending_high, high}};
    here.velocity = planned.at(spec.commands[k + 1].mode);
    if (here.velocity > next.velocity)  // (2)
      here.velocity = highest(next.velocity, here.velocity, [&](double v) {
        return distance(v, next.velocity, next.dynamics.deceleration, next.dynamics.jerk) <=
               next.length;
      });
  }
  double begin = 0;
  std::vector<double> velocities;
  for (const Point& here : points) {
    if (here.velocity > begin)  // (3)
      begin = highest(begin, here.velocity, [&](double v) {
        return distance(begin, v, here.dynamics.acceleration, here.dynamics.jerk) <= here.length;
      });
    else
      begin = here.velocity;
    velocities.push_back(begin);
  }
  return velocities;
}

TEST(QueueProperty, JunctionVelocitiesMeetAnIndependentLookAhead) {
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    QueueSpec spec;
    const int n = 2 + random.below(20);
    for (int k = 0; k < n; ++k) {
      const Dynamics d{random.log_uniform(0.3, 3), random.log_uniform(0.3, 3),
                       random.log_uniform(0.3, 3), i % 2 == 0 ? 0 : random.log_uniform(1, 100), 0};
      spec.commands.push_back({MoveRelative{random.log_uniform(0.03, 3)}, d,
                               static_cast<BufferMode>(1 + random.below(5))});
    }
    SCOPED_TRACE(text(spec));
    const QueuedMotion m = queue(spec);
    const std::vector<double> expected = looked_ahead(spec);
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_NEAR(m.commands[k].reached, expected[k], 1e-9 * m.commands[k].planned)
          << "command " << k + 1;
    if (HasFailure()) break;
  }
}

// ---- units and directions ----------------------------------------------------------------------------

QueueSpec scaled(QueueSpec spec, double length) {
  const double size = std::abs(length);
  spec.start = {spec.start.position * length, spec.start.velocity * length,
                spec.start.acceleration * length};
  for (QueuedCommand& c : spec.commands) {
    c.dynamics = {c.dynamics.velocity * size, c.dynamics.acceleration * size,
                  c.dynamics.deceleration * size, c.dynamics.jerk * size, 0};
    if (auto* m = std::get_if<MoveAbsolute>(&c.command)) m->position *= length;
    if (auto* m = std::get_if<MoveRelative>(&c.command)) m->distance *= length;
    if (auto* m = std::get_if<MoveVelocity>(&c.command); m != nullptr && length < 0)
      m->direction *= -1;
  }
  return spec;
}

TEST(QueueProperty, IsTheSameInEveryUnitAndInTheMirror) {
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const QueueSpec spec = random_queue(random, {1, i % 3 != 0, i % 2 == 0});
    SCOPED_TRACE(text(spec));
    const QueuedMotion m = queue(spec);
    for (const double length : {1024.0, 0x1p-20, -1.0}) {
      const QueuedMotion other = queue(scaled(spec, length));
      EXPECT_EQ(other.trajectory.end(), m.trajectory.end());
      for (std::size_t k = 0; k < m.commands.size(); ++k) {
        EXPECT_EQ(other.commands[k].end, m.commands[k].end);
        EXPECT_EQ(other.commands[k].reached, length * m.commands[k].reached);
      }
    }
    if (HasFailure()) break;
  }
}

}  // namespace
}  // namespace jounce::queue_property_test
