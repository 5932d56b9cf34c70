// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/integration.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// A cam follower that a spring holds down (the polydyne model). One mass m represents all moving
/// parts. The linkage, with its stiffness and damping, is between the cam and the mass. The return
/// spring is between the mass and the frame.
///
///     cam y --> [linkage k_l, c_l] --> mass m, x <-- [return spring k_s, c_s, preload F_0]
///
/// The linkage can push, but not pull. When its force would become negative, the follower leaves
/// the cam. The flight ends when the tip meets the cam again. follower.cpp contains the equations.
struct SpringFollower {
  double mass = 0;               ///< m, reduced to the cam, kg, > 0
  double linkage_stiffness = 0;  ///< k_l, N/m, > 0
  double linkage_damping = 0;    ///< c_l, N s/m, >= 0
  double spring_stiffness = 0;   ///< k_s, N/m, >= 0
  double spring_damping = 0;   ///< c_s, N s/m, >= 0: viscous damping of the spring and of the guide
  double preload = 0;          ///< F_0, force of the spring at lift 0, N, >= 0
  double meters_per_unit = 1;  ///< meters in one unit of the lift, > 0
};

/// Throws InputError, with the name of the member as key, for a value out of range, and for a
/// follower that is not pressed onto the cam (no preload and no spring).
void require_valid(const SpringFollower& follower);

/// Limits of a follower. A value that is not given is not limited, except least_force. u is the
/// unit of the lift.
struct FollowerLimits {
  std::optional<double> least_force = {};     ///< least contact force, N, >= 0; nullopt: 0
  std::optional<double> greatest_force = {};  ///< greatest contact force, N, > 0
  std::optional<double> impact_speed = {};    ///< greatest speed of an impact on the cam, m/s, > 0
  std::optional<double> residual = {};        ///< greatest residual vibration, u, > 0
};

/// Options of follow().
struct FollowerOptions {
  double settle = 0;  ///< standstill after the end of the lift, s, >= 0
  /// Number of samples, equally spaced over lift and standstill; for plots.
  std::size_t samples = 0;
  FollowerLimits limits = {};   ///< limits for the findings
  double tolerance = 1e-9;      ///< relative tolerance of the integration, 1e-12 to 1e-3
  long max_steps = 10'000'000;  ///< greatest number of steps of the integration, > 0
};

/// A period without contact between the follower and the cam. Unit u: the unit of the lift.
struct Flight {
  double from = 0;    ///< loss of the contact, s
  double to = 0;      ///< next contact, or the end of the standstill, s
  double height = 0;  ///< greatest gap, u
  /// Speed of the tip relative to the cam at the next contact, m/s; 0: no further contact.
  double impact_speed = 0;
};

/// The state of a follower at one instant.
struct FollowerSample {
  double time = 0;   ///< time, s
  double cam = 0;    ///< lift of the cam, u
  double mass = 0;   ///< position of the mass, u
  double force = 0;  ///< contact force, N
  double gap = 0;    ///< gap between tip and cam, u, >= 0
};

/// Result of follow(). Unit u: the unit of the lift.
struct FollowerResult {
  Integration integration = {};  ///< statistics of the integration
  Peak least_force = {};         ///< least contact force, N; 0 if the contact was lost
  Peak greatest_force = {};      ///< greatest contact force, N
  /// Greatest deviation of the mass from its rest position after the end of the lift, u.
  Peak residual = {};
  std::vector<Flight> flights = {};          ///< periods without contact
  std::vector<FollowerSample> samples = {};  ///< samples, if requested
  /// Findings: "follower/contact" always (the least force and its limit; broken if the force is
  /// less than the limit, or if the contact was lost); "follower/force", "follower/impact",
  /// "follower/residual" for each given limit; "follower/integration" if the integration failed.
  Report report = {};
};

/// Moves a follower by a rotating cam. `lift` is the lift of the cam over time, usually a Followed.
///
///     const Followed lift(cam, shaft);                       // at 3000 rpm
///     SpringFollower valve{.mass = 0.2, .linkage_stiffness = 5e6, .linkage_damping = 100,
///                    .spring_stiffness = 3e4, .preload = 250, .meters_per_unit = 1e-3};
///     const FollowerResult run = follow(lift, valve);
///     if (!run.flights.empty()) ...                            // floats: at run.flights[0].from
///
/// The follower begins at rest on the cam, in equilibrium. The tip has no mass, so it stays on the
/// cam when it lands: the linkage absorbs the speed of the tip. Only the mass can rebound, on the
/// linkage.
///
/// **Accuracy.** Losses of contact and landings are found as events, to 1e-8 of a turn of the
/// cam. Forces are within 1e-7 of their peak. (Tests compare with closed forms.)
///
/// **Errors.** Throws InputError for a follower, an option or a limit out of range, for a Table
/// over a master, and for a follower that is not pressed onto the cam at the start of the lift (key
/// "preload"). A failed integration is not an exception: see FollowerResult::integration.
FollowerResult follow(const SignalView& lift, const SpringFollower& follower,
                      const FollowerOptions& options = {});

/// Deleted: a Cam is not a motion over time. Combine it with a motion of its master first
/// (Followed).
FollowerResult follow(const Cam& lift, const SpringFollower& follower,
                      const FollowerOptions& options = {}) = delete;

}  // namespace jounce
