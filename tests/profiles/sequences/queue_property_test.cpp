// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <sstream>

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

/// The way of a velocity change without acceleration at either end, in closed form.
double way(double from, double to, double acceleration, double jerk) {
  const double dv = std::abs(to - from);
  const double rise = jerk == 0 ? 0 : acceleration / jerk;
  const double time =
      dv >= acceleration * rise ? dv / acceleration + rise : 2 * std::sqrt(dv / jerk);
  return (from + to) / 2 * time;
}

/// The velocity next to `to`, from `from`, for which the way fits.
template <class Fits>
double nearest(double from, double to, const Fits& fits) {
  if (fits(to)) return to;
  for (int i = 0; i < 200; ++i) (fits((from + to) / 2) ? from : to) = (from + to) / 2;
  return from;
}

double asked_for(BufferMode mode, double v, double w) {
  switch (mode) {
    case BufferMode::blending_low:
      return std::min(v, w);
    case BufferMode::blending_previous:
      return v;
    case BufferMode::blending_next:
      return w;
    case BufferMode::blending_high:
      return std::max(v, w);
    default:
      return 0;
  }
}

/// Junction velocities of moves in one direction from rest to rest: backward, then forward.
std::vector<double> looked_ahead(const QueueSpec& spec) {
  const std::size_t n = spec.commands.size();
  const auto length = [&](std::size_t k) {
    return std::get<MoveRelative>(spec.commands[k].command).distance;
  };
  const auto d = [&](std::size_t k) { return spec.commands[k].dynamics; };
  std::vector<double> exit(n, 0);
  for (std::size_t k = n - 1; k-- > 0;) {
    const double asked = asked_for(spec.commands[k + 1].mode, d(k).velocity, d(k + 1).velocity);
    const double out = exit[k + 1];
    exit[k] = asked <= out ? asked : nearest(out, asked, [&](double v) {
      return way(v, out, d(k + 1).deceleration, d(k + 1).jerk) <= length(k + 1);
    });
  }
  double v = 0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    if (exit[k] > v)
      exit[k] = nearest(v, exit[k], [&](double w) {
        return way(v, w, d(k).acceleration, d(k).jerk) <= length(k);
      });
    v = exit[k];
  }
  return exit;
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
                               static_cast<BufferMode>(2 + random.below(4))});
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
