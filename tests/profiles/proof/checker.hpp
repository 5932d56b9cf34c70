// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/profiles/moves/move.hpp"

namespace jounce::proof {

/// One question to the solver; with `duration`, one of exactly that length.
struct Case {
  MotionState from = {};
  MotionState to = {};
  Bounds bounds = {};
  std::optional<double> duration = {};
  bool by_velocity = false;  ///< move_velocity: the target position is the end of that motion
};

/// The C++ line that asks it again, doubles as hex.
std::string reproducer(const Case& c);

/// Sums of the magnitudes of all the terms that make up position, velocity and acceleration along
/// the motion: what rounding is measured against.
///
///     acceleration  |a0| + |a1| + sum of |j| t
///     velocity      |v0| + |v1| + (a0^2 + a1^2)/(2 J) + sum of |a| t + |j| t^2/2
///     position      |p0| + |p1| + (|a0|^3 + |a1|^3)/(6 J^2) + sum of |v| t + |a| t^2/2 + |j| t^3/6
///
/// over the phases, v and a being those at a phase's begin (order 2 and 1 accordingly), J the larger
/// bound of jerk: what it takes to bring the ends' accelerations to zero is part of them.
///
/// Where more cancels than these sums show (a brake from 1e6 to 1e-3 u/s, then a long cruise: the
/// last bit of a brake's length is a drift for hours), the floor is 16 ulp of the same sums with
/// nothing cancelled, that is with |p|, |v|, |a| and |j| integrated: no motion that is stored as
/// phases of doubles can be expected to do better. A velocity or acceleration is not resolved finer
/// than 4 ulp of its smaller bound either.
struct Scale {
  long double position = 0;
  long double velocity = 0;
  long double acceleration = 0;
};

/// Result of a check. `fault` is empty if there is none, else one sentence.
struct Verdict {
  std::string fault;
  double end_error = 0;      ///< error of the end state, worst of three, relative to `scale`
  double excess = 0;         ///< beyond a limit, relative to it; see check
  long double duration = 0;  ///< sum of the phases in long double
  long double instant = 0;   ///< resolution of the duration: see `a duration asked for` below
  Scale scale;
  Scale floor;  ///< the least that is resolved: the ulps named above, in u, u/s, u/s^2

  [[nodiscard]] bool ok() const { return fault.empty(); }
};

/// The tolerance of every relation below that is not exact.
constexpr double tolerance = 1e-12;

/// Integrates a profile anew from its phases in long double, without the library's own evaluation,
/// and compares with what was asked:
///
/// - start() and end() are the states asked for, bit for bit (without the velocity in order 1 and
///   the acceleration in order 2 and 1, which step); no number is NaN or infinite; every
///   phase is longer than 0; duration() is the sum; a duration asked for is kept, to
///   `tolerance` of it and of the time in which the acceleration (order 2: velocity) builds up;
/// - the integrated end state is the target, to `tolerance` of the scale above;
/// - jerk, acceleration, velocity and position keep their bounds, extrema inside the phases
///   included, to `tolerance` of the larger magnitude of that quantity's two bounds, of the start
///   and its unavoidable peak (a position: of the scale above), or to the floor above;
/// - from a start outside, acceleration and velocity keep their envelopes instead (envelope.hpp): an
///   acceleration returns at full jerk, a velocity is at no instant beyond that of the fastest level
///   return. A start that brakes towards the target harder than its limit may go on so only as far as
///   that keeps it from passing the target (`in_force`); the end of such a hold is resolved to 4 ulp.
Verdict check(const Profile& profile, const Case& c);

}  // namespace jounce::proof
