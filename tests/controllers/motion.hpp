// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/dynamics.hpp"

#include "support/invariants.hpp"

namespace jounce {

inline std::ostream& operator<<(std::ostream& out, const MotionState& s) {
  return out << "{" << number(s.position) << ", " << number(s.velocity) << ", "
             << number(s.acceleration) << "}";
}
inline std::ostream& operator<<(std::ostream& out, const Dynamics& d) {
  return out << "{" << number(d.velocity) << ", " << number(d.acceleration) << ", "
             << number(d.deceleration) << ", " << number(d.jerk) << ", "
             << number(d.deceleration_jerk) << "}";
}

namespace test {

/// End state of a profile's phases from its start, added up one by one. Shares nothing with
/// Profile::at and curve(), which use the end.
inline MotionState integrated(const Profile& profile) {
  double p = profile.start().position;
  double v = profile.start().velocity;
  double a = profile.start().acceleration;
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const double t = profile.phase(i).duration;
    const double value = profile.phase(i).value;
    const double j = profile.order() == 3 ? value : 0;
    if (profile.order() == 2) a = value;
    p += t * (v + t * (a / 2 + t * j / 6));
    v += t * (a + t * j / 2);
    a += t * j;
  }
  return {p, v, a};
}

/// The phases lead from the start to the profile's end, within rounding.
inline void expect_arrives(const Profile& profile, double tolerance = 1e-12) {
  const MotionState end = integrated(profile);
  const double T = profile.duration();
  const Ranges r = extrema(profile.curve());
  const double v = std::abs(r[1].peak().value);
  const double p = std::max(std::abs(r[0].peak().value), v * T);
  EXPECT_NEAR(end.position, profile.end().position, tolerance * p);
  EXPECT_NEAR(end.velocity, profile.end().velocity, tolerance * v);
  if (profile.order() == 3) {
    EXPECT_NEAR(end.acceleration, profile.end().acceleration,
                tolerance * std::abs(r[2].peak().value));
  }
}

/// |f'| <= velocity, |f''| <= acceleration, |f'''| <= jerk.
inline void expect_within(const Trajectory& f, double velocity, double acceleration,
                          double jerk = std::numeric_limits<double>::infinity()) {
  const Ranges r = extrema(f);
  EXPECT_LE(std::abs(r[1].peak().value), velocity * (1 + 1e-11));
  EXPECT_LE(std::abs(r[2].peak().value), acceleration * (1 + 1e-11));
  EXPECT_LE(std::abs(r[3].peak().value), jerk * (1 + 1e-11));
}

/// Speeding up with at most `acceleration`, slowing down with at most `deceleration`, by a dense
/// sample; at standstill either may hold.
inline void expect_speeding_and_slowing(const Trajectory& f, double acceleration,
                                        double deceleration) {
  const double standstill = 1e-9 * std::abs(extrema(f, 1).peak().value);
  for (std::size_t i = 0; i < f.segments().size(); ++i)
    for (int n = 0; n <= 32; ++n) {
      const Jet x = evaluate(f.segments()[i], n / 32.0);
      if (std::abs(x[1]) <= standstill) continue;
      const double limit = x[1] * x[2] > 0 ? acceleration : deceleration;
      EXPECT_LE(std::abs(x[2]), limit * (1 + 1e-9)) << "segment " << i + 1;
    }
}

}  // namespace test
}  // namespace jounce
