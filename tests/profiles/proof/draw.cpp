// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/draw.hpp"

#include <cassert>
#include <cmath>
#include <cstring>
#include <numbers>

#include "profiles/proof/reachable.hpp"
#include "support/draw_until.hpp"

namespace jounce::proof {

double normal(Random& random, double deviation) {
  const double u = 1 - random.uniform(0, 1);
  const double turn = random.uniform(0, 2 * std::numbers::pi);
  return deviation * std::sqrt(-2 * std::log(u)) * std::cos(turn);
}

double normal_or_zero(Random& random, double probability, double deviation) {
  return random.uniform(0, 1) < probability ? normal(random, deviation) : 0.0;
}

namespace {

/// Draws again until the target can be reached.
template <class F>
Case reachable_case(Random& random, F once) {
  return test::draw_until([&] { return once(random); },
                          [](const Case& c) { return safe_target(c.to, c.bounds); });
}

struct Chance {
  double v0, a0, v1, a1;
};

/// States of Ruckig's random tests: positions N(0, 4), rates N(0, 0.8) or at rest.
Case ruckig_states(Random& r, const Chance& p) {
  Case c;
  c.from = {normal(r, 4), normal_or_zero(r, p.v0, 0.8), normal_or_zero(r, p.a0, 0.8)};
  c.to = {normal(r, 4), normal_or_zero(r, p.v1, 0.8), normal_or_zero(r, p.a1, 0.8)};
  return c;
}

/// Limits drawn uniformly above the target's rates.
Bounds above_target(Random& r, const MotionState& to, double lo, double hi) {
  const double v = r.uniform(lo, hi) + std::abs(to.velocity);
  const double a = r.uniform(lo, hi) + std::abs(to.acceleration);
  return within(v, a, r.uniform(lo, hi));
}

constexpr Chance often{0.9, 0.8, 0.7, 0.6};
constexpr Chance seldom{0.1, 0.1, 0.1, 0.1};

Case ruckig(Random& random, const Chance& chance, double lo, double hi) {
  return reachable_case(random, [&](Random& r) {
    Case c = ruckig_states(r, chance);
    c.bounds = above_target(r, c.to, lo, hi);
    return c;
  });
}

Case test(Random& r) {
  return ruckig(r, often, 0.08, 16);
}
Case bench(Random& r) {
  return ruckig(r, often, 0.1, 12);
}
Case high(Random& r) {
  return ruckig(r, seldom, 10, 1e6);
}

Case discrete(Random& random) {
  return reachable_case(random, [](Random& r) {
    const auto step = [&r] { return static_cast<double>(r.below(3) - 1); };
    Case c;
    c.from = {step(), step(), step()};
    c.to = {step(), step(), step()};
    c.bounds = within(1 + r.below(2) + std::abs(c.to.velocity),
                      1 + r.below(2) + std::abs(c.to.acceleration), 1 + r.below(2));
    return c;
  });
}

/// Everything a multiple of one half, so that branches of the solution tie exactly.
Case ties(Random& random) {
  return reachable_case(random, [](Random& r) {
    const auto half = [&r](int n) { return (r.below(2 * n + 1) - n) / 2.0; };
    const auto limit = [&r] { return (1 + r.below(4)) / 2.0; };
    Case c;
    c.from = {half(4), half(2), half(2)};
    c.to = {half(4), half(2), half(2)};
    c.bounds = within(limit(), limit(), limit());
    return c;
  });
}

/// The same in units of length that are no power of two, and of time 1 to 1/10: still multiples of
/// one half, but the formulas round differently where branches tie.
Case integers(Random& r) {
  Case c = ties(r);
  const double length = 1 + r.below(2000);
  const double rate = 1 + r.below(10);
  const double v = length * rate;
  const double a = v * rate;
  for (MotionState* s : {&c.from, &c.to})
    *s = {s->position * length, s->velocity * v, s->acceleration * a};
  c.bounds = within(c.bounds.velocity_max * v, c.bounds.acceleration_max * a,
                    c.bounds.jerk_max * a * rate);
  return c;
}

/// Each direction on its own.
Case directional(Random& random) {
  return reachable_case(random, [](Random& r) {
    Case c = ruckig_states(r, often);
    c.bounds = above_target(r, c.to, 0.08, 16);
    c.bounds.velocity_min = -r.uniform(0.08, 16) - std::abs(c.to.velocity);
    c.bounds.acceleration_min = -r.uniform(0.08, 16) - std::abs(c.to.acceleration);
    c.bounds.jerk_min = -r.uniform(0.08, 16);
    return c;
  });
}

/// The same problem in units of length and time between 1e-6 and 1e6.
Case units(Random& r) {
  Case c = test(r);
  const double length = r.log_uniform(1e-6, 1e6);
  const double rate = r.log_uniform(1e-6, 1e6);
  for (MotionState* s : {&c.from, &c.to}) {
    s->position *= length;
    s->velocity *= length * rate;
    s->acceleration *= length * rate * rate;
  }
  c.bounds = within(c.bounds.velocity_max * length * rate,
                    c.bounds.acceleration_max * length * rate * rate,
                    c.bounds.jerk_max * length * rate * rate * rate);
  return safe_target(c.to, c.bounds) ? c : units(r);
}

/// Limits over six decades each, states in proportion to them, distances over six decades.
Case decades(Random& random) {
  const auto once = [](Random& r) {
    const auto limit = [&r] { return r.log_uniform(1e-3, 1e3); };
    Case c;
    c.bounds = within(limit(), limit(), limit());
    const auto part = [&r](double of) { return r.below(2) == 0 ? 0.0 : r.uniform(-of, of); };
    c.from = {r.uniform(-1, 1) * limit(), part(c.bounds.velocity_max),
              part(c.bounds.acceleration_max)};
    c.to = {r.uniform(-1, 1) * limit(), part(c.bounds.velocity_max),
            part(c.bounds.acceleration_max)};
    return c;
  };
  // A start that is not safe here would pass its limits a million times over.
  return test::draw_until([&] { return reachable_case(random, once); },
                          [](const Case& c) { return safe_start(c.from, c.bounds); });
}

/// Almost there already: what a controller is left with at the end of a move (pantor/ruckig#160).
Case residual(Random& random) {
  return reachable_case(random, [](Random& r) {
    const auto speck = [&r](double of) {
      return r.below(3) == 0 ? 0.0 : of * r.uniform(-1, 1) * r.log_uniform(1e-18, 1e-4);
    };
    Case c = ruckig_states(r, {0, 0, 0.3, 0.3});
    c.bounds = above_target(r, c.to, 1, 150);
    c.from = {c.to.position + speck(1), c.to.velocity + speck(1), c.to.acceleration + speck(10)};
    return c;
  });
}

/// Starts up to five times outside. One limit of two is that of either direction alone.
Case outside(Random& r) {
  Case c = r.below(2) == 0 ? test(r) : directional(r);
  const auto times = [&r](double min, double max) {
    return r.uniform(0, 5) * (r.below(2) == 0 ? min : max);
  };
  if (r.below(3) != 0) c.from.velocity = times(c.bounds.velocity_min, c.bounds.velocity_max);
  if (r.below(3) != 0)
    c.from.acceleration = times(c.bounds.acceleration_min, c.bounds.acceleration_max);
  return c;
}

/// A motion inside its bounds, whose limits (of velocity alone, or all) are lowered on the way; to
/// the same target or another.
Case lowered(Random& random) {
  return reachable_case(random, [](Random& r) {
    Case c = r.below(2) == 0 ? test(r) : directional(r);
    c.from = {c.from.position, 0, 0};
    if (r.below(2) == 0) c.to = {c.to.position, 0, 0};
    const MoveResult before = move_to(c.from, c.to, c.bounds);
    const Motion now = before.profile.at(before.profile.duration() * r.uniform(0, 1));
    c.from = {now.position, now.velocity, now.acceleration};
    const bool all = r.below(2) == 0;
    const auto lower = [&r](double& limit) { limit *= r.uniform(0.02, 1); };
    lower(c.bounds.velocity_min);
    lower(c.bounds.velocity_max);
    if (all)
      for (double* limit : {&c.bounds.acceleration_min, &c.bounds.acceleration_max,
                            &c.bounds.jerk_min, &c.bounds.jerk_max})
        lower(*limit);
    if (r.below(3) == 0) c.to.position = now.position + normal(r, 2);
    return c;
  });
}

/// Jerks whose magnitudes in the two directions differ.
Case with_ratio(Random& random, double most) {
  return reachable_case(random, [most](Random& r) {
    Case c = r.below(2) == 0 ? directional(r) : outside(r);
    (r.below(2) == 0 ? c.bounds.jerk_min : c.bounds.jerk_max) /= r.log_uniform(1, most);
    return c;
  });
}
Case ratios(Random& r) {
  return with_ratio(r, 1e2);
}
Case extremes(Random& r) {
  return with_ratio(r, 1e6);
}

/// Every limit on its own over `decades`, states in proportion to those of their direction.
Case of_unequal_limits(Random& r, double decades) {
  const double far = std::pow(10.0, decades / 2);
  const auto limit = [&r, far] { return r.log_uniform(1 / far, far); };
  const auto between = [&r](double min, double max) {
    const int kind = r.below(4);
    if (kind == 0) return 0.0;
    if (kind == 1) return r.below(2) == 0 ? min : max;
    return r.uniform(0, 1) * (r.below(2) == 0 ? min : max);
  };
  Case c;
  Bounds& b = c.bounds;
  b = {-limit(), limit(), -limit(), limit(), -limit(), limit()};
  for (MotionState* s : {&c.from, &c.to})
    *s = {r.uniform(-1, 1) * limit(), between(b.velocity_min, b.velocity_max),
          between(b.acceleration_min, b.acceleration_max)};
  return c;
}
Case unequal(Random& random) {
  const auto once = [](Random& r) { return of_unequal_limits(r, 4); };
  return test::draw_until([&] { return reachable_case(random, once); },
                          [](const Case& c) { return safe_start(c.from, c.bounds); });
}

/// From rest to rest, each direction on its own or not.
Case resting(Random& r) {
  Case c = r.below(2) == 0 ? bench(r) : directional(r);
  c.from = {c.from.position, 0, 0};
  c.to = {c.to.position, 0, 0};
  return c;
}

/// The state after a random jerk, held for t: as far as the acceleration stays inside and above zero.
MotionState driven(const MotionState& s, const Bounds& b, double t, double share) {
  const double jerk = b.jerk_min + share * (b.jerk_max - b.jerk_min);
  const double most =
      jerk > 0 ? (b.acceleration_max - s.acceleration) / jerk : s.acceleration / -jerk;
  t = std::min(t, std::max(most, 0.0));
  return {s.position + t * (s.velocity + t * (s.acceleration / 2 + t * jerk / 6)),
          s.velocity + t * (s.acceleration + t * jerk / 2), s.acceleration + t * jerk};
}

/// Starts that run out of the velocity limit, upwards, and targets that may be met before: now and then
/// beside it.
template <class F>
Case leaving_from(Random& random, F base) {
  return reachable_case(random, [base](Random& r) {
    Case c = base(r);
    const Bounds& b = c.bounds;
    c.from.acceleration =
        b.acceleration_max * (r.below(8) == 0 ? r.uniform(1, 2) : r.uniform(0, 1));
    const double out = c.from.acceleration * c.from.acceleration / (2 * -b.jerk_min);
    c.from.velocity = std::max(b.velocity_max - out * r.uniform(0, 1), b.velocity_min);
    MotionState s = c.from;
    if (s.acceleration > b.acceleration_max)
      s = driven(s, b, (s.acceleration - b.acceleration_max) / -b.jerk_min, 0);
    for (int i = r.below(4); i >= 0; --i)
      s = driven(s, b, r.uniform(0, 1) * s.acceleration / -b.jerk_min, r.uniform(0, 1));
    c.to = s;
    if (r.below(4) == 0) c.to.position += normal(r, 0.1);
    return c;
  });
}
Case leaving(Random& random) {
  return leaving_from(random, directional);
}
/// The same with limits that lie far from each other.
Case leaving_unequal(Random& random) {
  return leaving_from(random, [](Random& r) { return of_unequal_limits(r, 4); });
}

Case second(Random& random) {
  return reachable_case(random, [](Random& r) {
    Case c = ruckig_states(r, {0.9, 0, 0.7, 0});
    c.bounds = above_target(r, c.to, 0.08, 16);
    if (r.below(2) == 0) c.bounds.velocity_min = -r.uniform(0.08, 16) - std::abs(c.to.velocity);
    if (r.below(2) == 0) c.bounds.acceleration_min = -r.uniform(0.08, 16);
    c.bounds.jerk_max = Bounds::none;
    c.bounds.jerk_min = -Bounds::none;
    return c;
  });
}

Case first(Random& r) {
  Case c;
  c.from.position = normal(r, 4);
  c.to.position = normal(r, 4);
  c.bounds.velocity_max = r.log_uniform(1e-3, 1e3);
  c.bounds.velocity_min = -r.log_uniform(1e-3, 1e3);
  return c;
}

/// Without a limit of velocity, of acceleration, or of both.
Case unlimited(Random& random) {
  return reachable_case(random, [](Random& r) {
    Case c = ruckig_states(r, often);
    c.bounds = above_target(r, c.to, 0.08, 16);
    const int which = r.below(3);
    if (which != 0) {
      c.bounds.velocity_max = Bounds::none;
      c.bounds.velocity_min = -Bounds::none;
    }
    if (which != 1) {
      c.bounds.acceleration_max = Bounds::none;
      c.bounds.acceleration_min = -Bounds::none;
    }
    return c;
  });
}

constexpr Draw all[] = {
    {"test", "Ruckig's random test: positions N(0,4), rates N(0,0.8), limits 0.08 to 16", test},
    {"bench", "Ruckig's benchmark: the same, limits 0.1 to 12", bench},
    {"high", "Ruckig's test of high limits: 10 to 1e6", high},
    {"discrete", "Ruckig's discrete test: states -1, 0, 1, limits 1, 2", discrete},
    {"ties", "everything a multiple of one half", ties},
    {"integers", "the same in units of length 1 to 2000, of time 1 to 1/10", integers},
    {"directional", "each direction with limits of its own", directional},
    {"units", "units of length and time times 1e-6 to 1e6", units},
    {"decades", "limits and distances over six decades", decades},
    {"residual", "almost there already", residual},
    {"outside", "starts up to five times outside the limits", outside},
    {"lowered", "limits lowered in motion, target kept or changed", lowered, true},
    {"ratios", "jerk in one direction up to a hundred times that in the other", ratios, true},
    {"extremes", "jerk in one direction up to a million times that in the other", extremes, true},
    {"resting", "from rest to rest", resting},
    {"leaving", "starts that run out of the limit, and targets that do", leaving, true},
    {"unequal", "every limit on its own over four decades", unequal, true},
    {"leaving-unequal", "the same, starts and targets that run out of the limit", leaving_unequal,
     true},
    {"unlimited", "no limit of velocity, of acceleration, or of both", unlimited},
    {"second", "no limit of jerk", second},
    {"first", "no limit of acceleration", first},
};

}  // namespace

std::span<const Draw> draws() {
  return all;
}

Case draw(const char* name, Random& random) {
  for (const Draw& d : all)
    if (std::strcmp(d.name, name) == 0) return d.draw(random);
  assert(false);
  return {};
}

}  // namespace jounce::proof
