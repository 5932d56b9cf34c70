// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/curve.hpp"

#include "support/random.hpp"

namespace jounce::test {

/// One segment of a random law, or a quintic between random end states.
inline std::vector<Segment> random_rise(Random& random, bool quintics, double length, double from,
                                        double to) {
  std::vector<Law> laws;
  for (const LawInfo& about : all_laws())
    if (has_own_shape(about.law) && about.law != Law::dwell) laws.push_back(about.law);
  const auto choice =
      static_cast<std::size_t>(random.below(static_cast<int>(laws.size()) + (quintics ? 2 : 0)));
  if (choice >= laws.size()) {
    const double slope = (to - from) / length;
    const auto v = [&] { return random.uniform(-3, 3) * slope; };
    return {quintic(length, from, v(), v() / length, to, v(), v() / length)};
  }
  std::vector<Segment> pieces;
  LawForm form;
  if (laws[choice] == Law::scca) form.shares = {0.2, 0.3, 0.5};
  for (const Segment& piece : normalized(laws[choice], form)) {
    pieces.push_back(scaled(piece, to - from, from));
    pieces.back().length *= length;
  }
  return pieces;
}

/// A cam of 1 to 6 segments of any law, over a master and a slave of any size and place, continuous
/// in position only. `one_way`: the slave never turns back, and dwells have a motion on both sides.
inline Cam random_cam(Random& random, bool one_way, Extrapolation outside = Extrapolation::hold) {
  const double master = random.log_uniform(1e-9, 1e9);
  const double slave = random.log_uniform(1e-9, 1e9);
  const double sign = random.below(2) == 0 ? 1 : -1;
  double at = random.uniform(-5, 5) * slave;
  std::vector<Segment> all;
  const int count = 1 + random.below(6);
  for (int i = 0; i < count; ++i) {
    const double length = random.log_uniform(0.01, 1) * master;
    if (random.below(5) == 0 && (!one_way || (i > 0 && i + 1 < count))) {
      all.push_back(line(length, at, at));
      continue;
    }
    const double to =
        at + (one_way ? sign : random.uniform(-1, 1)) * random.log_uniform(0.01, 1) * slave;
    for (const Segment& piece : random_rise(random, !one_way, length, at, to)) all.push_back(piece);
    at = to;
  }
  return Cam(std::move(all), random.uniform(-5, 5) * master, outside);
}

}  // namespace jounce::test
