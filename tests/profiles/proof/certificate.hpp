// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "profiles/proof/envelope.hpp"

namespace jounce::proof {

/// The question: can an axis go from one state to another in some duration? Third order; position
/// limits are not considered.
struct Question {
  Freedom start = {};  ///< the motion before it is forced, and no part of the durations
  MotionState to = {};
  Bounds bounds = {};              ///< in force
  bool position = true;            ///< false: velocity and acceleration alone (move_velocity)
  Envelope top = {}, bottom = {};  ///< envelope of the velocity; `bottom`: of the negated one
};
Question question(const MotionState& from, const MotionState& to, const Bounds& bounds);
/// The same for durations longer than the shortest (`Force::longer`).
Question question_of_longer(const MotionState& from, const MotionState& to, const Bounds& bounds);
Question question_of_velocity(const MotionState& from, const MotionState& to, const Bounds& bounds);

/// A separating functional: weights of the state at the instant T, and pressures on the limits before
/// (> 0 on an upper one, < 0 on a lower one).
struct Functional {
  /// A limit that presses on a whole stretch, with the density that keeps q at zero.
  enum class Flat : std::uint8_t { none, acceleration, velocity };
  struct Instant {
    Real t = 0;
    Real velocity = 0, acceleration = 0;  ///< pressures
    Flat before = Flat::none;             ///< pressure on the stretch that ends here
  };
  Real p = 0, v = 0, a = 0;
  std::vector<Instant> at;  ///< ascending, the last is T
};

/// **The certificate that there is no motion.** Let F = p x + v x' + a x'' at T. For every admissible
/// motion and any pressures m, n (at instants, or spread),
///
///     F <= F + sum m_i (V(t_i) - v(t_i)) + sum n_i (A(t_i) - a(t_i)),                        (1)
///
/// as each term added is >= 0 (V, A being the upper envelope where the pressure is > 0, the lower
/// one where it is < 0). The right side is linear in the jerk alone: a constant and the integral of
/// q(t) j(t), q piecewise quadratic,
///
///     q(t) = p (T - t)^2/2 + v (T - t) + a - sum over t_i > t of (m_i (t_i - t) + n_i)        (2)
///
/// so that it is nowhere greater than with j = jerk_max where q > 0 and jerk_min where q < 0. That
/// is `bound`, integrated exactly (long double). If F of the target is greater, no motion gets
/// there in T. This is weak duality: it holds for *any* weights and pressures, needs no
/// discretisation, and does not depend on the shape of an optimal motion. `drift`: by how much the
/// velocity limits of the last `late` s are moved outwards.
Real bound(const Functional& f, const Question& q, Real drift = 0, Real late = 0);

/// Distance of the target beyond `bound`, in units of F.
Real margin(const Functional& f, const Question& q);

/// The least duration (of the whole motion) from which on, up to `to`, there certainly is no
/// motion; not less than `from`; `to` itself if nothing is proven. The search goes down from `to`.
/// Each functional excludes a whole interval: a motion that reaches the target earlier could
/// continue with its acceleration until T, which (1) excludes as well (the velocity may then drift
/// past its limit by a1 times that time, which `bound` adds). The functionals come from a linear
/// program (program.hpp).
Real impossible_from(const Question& q, Real from, Real to);

}  // namespace jounce::proof
