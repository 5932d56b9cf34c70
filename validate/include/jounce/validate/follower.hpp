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

/// A cam follower that a spring holds down: the polydyne model. One mass represents all moving
/// parts. Between it and the cam are the stiffness and the damping of the linkage, behind it the
/// return spring.
///
///     cam y --> [linkage k_l, c_l] --> mass m, x <-- [return spring k_s, c_s, preload F_0]
///
/// The linkage pushes and does not pull: when its force would be negative, the follower leaves the
/// cam and flies until the tip meets the cam again. Equations: at the head of follower.cpp.
struct SpringFollower {
  double mass = 0;               ///< kg, > 0, at the cam
  double linkage_stiffness = 0;  ///< k_l, N/m, > 0
  double linkage_damping = 0;    ///< c_l, N s/m, >= 0
  double spring_stiffness = 0;   ///< k_s, N/m, >= 0
  double spring_damping = 0;     ///< c_s, N s/m, >= 0: of the spring and of the guide, viscous
  double preload = 0;            ///< F_0, N, >= 0, of the spring at signal 0
  double metres_per_unit = 1;    ///< > 0: of the signal's position unit
};

/// Throws InputError, with the field's name as key, for a value out of range, and for a follower that nothing presses
/// on the cam (no preload and no spring).
void require_valid(const SpringFollower& follower);

/// Limits of the follower; an omitted value is not limited.
struct FollowerLimits {
  std::optional<double> least_force = {};     ///< N, >= 0, of the contact; omitted: 0
  std::optional<double> greatest_force = {};  ///< N, > 0, of the contact
  std::optional<double> impact_speed = {};    ///< m/s, > 0, when it lands
  std::optional<double> residual = {};        ///< u, > 0
};

struct FollowerOptions {
  double settle = 0;        ///< s of standstill after the signal's end, >= 0
  std::size_t samples = 0;  ///< for plots: equally spaced over signal and standstill
  FollowerLimits limits = {};
  double tolerance = 1e-9;      ///< relative, of the integration, in [1e-12, 1e-3]
  long max_steps = 10'000'000;  ///< > 0
};

/// Once in the air.
struct Flight {
  double from = 0;          ///< s, the contact is lost
  double to = 0;            ///< s, the tip is back on the cam, or the run is over
  double height = 0;        ///< u, the greatest gap
  double impact_speed = 0;  ///< m/s, of tip against cam as they meet; 0: still in the air
};

struct FollowerSample {
  double time = 0;   ///< s
  double cam = 0;    ///< u
  double mass = 0;   ///< u
  double force = 0;  ///< N, between tip and cam
  double gap = 0;    ///< u, >= 0, between tip and cam
};

struct FollowerResult {
  Integration integration;
  Peak least_force;     ///< N, of the contact; 0 once it is lost
  Peak greatest_force;  ///< N
  Peak residual;        ///< u, of the mass about its place of rest, after the signal's end
  std::vector<Flight> flights;
  std::vector<FollowerSample> samples;
  /// Always "follower/contact", the least force against its limit, broken if contact was lost;
  /// "follower/force", "follower/impact", "follower/residual" against the limits given; and
  /// "follower/integration" if the integration failed.
  Report report;
};

/// Drives a follower by a cam that turns: the signal is the cam's lift over time, a Followed.
///
///     const Followed lift(cam, shaft);                       // at 3000 rpm
///     SpringFollower valve{.mass = 0.2, .linkage_stiffness = 5e6, .linkage_damping = 100,
///                    .spring_stiffness = 3e4, .preload = 250, .metres_per_unit = 1e-3};
///     const FollowerResult run = follow(lift, valve);
///     if (!run.flights.empty()) ...                            // floats: at run.flights[0].from
///
/// It begins at rest in equilibrium on the cam. The tip has no mass: when it lands it stays on the cam,
/// its speed taken by the linkage, and nothing rebounds but the mass on the linkage itself.
///
/// **Accuracy**: loss of contact and landing found as events; within 1e-8 of a period of the exact
/// instants, forces within 1e-7 of their peak (pinned by tests against closed forms).
///
/// Throws InputError for a follower, option or limit out of range, and for a Table over master
/// position. An integration that fails is an outcome.
FollowerResult follow(const SignalView& lift, const SpringFollower& follower,
                      const FollowerOptions& options = {});

/// A Cam is not a motion over time: give it a master first (Followed).
FollowerResult follow(const Cam& lift, const SpringFollower& follower,
                      const FollowerOptions& options = {}) = delete;

}  // namespace jounce
