#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/profiles/curve.hpp"
#include "jounce/profiles/limits.hpp"
#include "jounce/validate/integration.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// A servo axis as two masses on a shaft, under a position loop (P), a velocity loop (PI), and
/// feed-forward of velocity and of the torque that accelerates both masses. Everything is seen at
/// the motor's shaft: a load behind a gear of ratio i counts its inertia, stiffness and damping
/// divided by i^2. The equations stand in docs/validate.md and at the head of drive_model.cpp.
///
/// The controller is continuous: no sampling, no quantised encoder, no delay of the current loop.
struct Drive {
  double motor_inertia = 0;    ///< J_m, kg m^2, > 0
  double load_inertia = 0;     ///< J_l, kg m^2, > 0
  double shaft_stiffness = 0;  ///< c, N m/rad, > 0
  double shaft_damping = 0;    ///< d, N m s/rad, >= 0
  double motor_friction = 0;   ///< b_m, viscous, N m s/rad, >= 0
  double load_friction = 0;    ///< b_l, viscous, N m s/rad, >= 0

  double position_gain = 0;          ///< K_p, 1/s, > 0
  double velocity_gain = 0;          ///< K_v, N m s/rad, > 0
  double integral_time = 0;          ///< T_i of the velocity loop, s, > 0; 0: no integral part
  double velocity_feed_forward = 1;  ///< share of the reference's velocity, >= 0; 1: all of it
  double torque_feed_forward = 1;    ///< share of (J_m + J_l) times acceleration, >= 0; 1: all

  double torque_limit = 0;      ///< N m, > 0
  double position_per_rev = 0;  ///< u/rev, > 0: the signal's position unit per motor revolution
};

/// An axis of the size of a 400 W servo: 3.8 N m peak, a load of five times the motor's inertia on
/// a shaft that resonates near 80 Hz against a held motor, loops tuned for it by hand. The numbers
/// are round and of that order of magnitude; they are not a product's data sheet. Unit: degrees of
/// the motor shaft.
Drive servo_400w();

/// Throws InputError, with the field's name as key, for a value out of range.
void require_valid(const Drive& drive);

/// What the axis may do; what is left out is not limited. All > 0.
struct DriveLimits {
  std::optional<double> torque;           ///< N m, peak
  std::optional<double> rms_torque;       ///< N m
  std::optional<double> following_error;  ///< u
  std::optional<double> residual;         ///< u
};

struct DriveOptions {
  double settle = 0.2;      ///< s of standstill after the reference's end, >= 0
  std::size_t samples = 0;  ///< for plots: equally spaced over reference and standstill
  DriveLimits limits = {};
  double tolerance = 1e-8;      ///< relative, of the integration, in [1e-12, 1e-3]
  long max_steps = 10'000'000;  ///< > 0
};

/// A signed value at its largest magnitude, and when.
struct Peak {
  double value = 0;
  double where = 0;  ///< s
};

/// The torque stood at its limit over an interval of time, entered and left at these instants.
struct Saturation {
  double from = 0;  ///< s
  double to = 0;    ///< s
  int sign = 0;     ///< 1: at +torque_limit, -1: at -torque_limit
};

struct DriveSample {
  double time = 0;             ///< s
  double reference = 0;        ///< u
  double motor = 0;            ///< u
  double load = 0;             ///< u
  double torque = 0;           ///< N m, of the motor
  double following_error = 0;  ///< u, reference - motor
};

struct DriveResult {
  Integration integration;
  Peak torque;                     ///< N m
  double rms_torque = 0;           ///< N m, over the reference's duration (the standstill excluded)
  Peak following_error;            ///< u, reference - motor
  double end_following_error = 0;  ///< u, at the reference's end
  Peak residual;                   ///< u, load - reference, after the reference's end
  double residual_frequency = 0;   ///< Hz, of the load after the end; 0: it does not swing
  std::vector<Saturation> saturation;
  std::vector<DriveSample> samples;
  /// "drive/torque", "drive/rms_torque", "drive/following_error", "drive/residual" against the
  /// limits given; always "drive/saturation", broken where the torque limit was reached at all; and
  /// "drive/integration" where the integration did not end well.
  Report report;
};

/// Drives the axis along a reference over time, from rest at its start, then holds its end.
///
///     Drive drive = servo_400w();
///     drive.position_per_rev = 10;                                 // mm: a screw of 10 mm pitch
///     const DriveResult run = drive_through(table, drive, {.limits = {.following_error = 0.5}});
///     if (!run.report.ok()) ...
///
/// The reference is what the executor will interpolate: a Table over time, a Trajectory, a Followed
/// made from a table's curve. It begins with the axis at rest at the reference's first position,
/// shaft relaxed, integral part empty; a reference that starts or ends moving is met as the step of
/// velocity that it is.
///
/// **Accuracy**: motor and load within 1e-9 of the stroke of the exact solution (pinned by tests
/// against matrix exponentials; 2e-11 is usual, 1e-8 where a move is over before the loop can
/// follow), rms torque within 1e-6 of itself. Peaks are taken
/// from parabolas through the solver's own steps: within 1e-4 of themselves. Frequency: from the
/// zeros of the load's velocity, as long as they stand out by 1 % of its peak.
///
/// Throws InputError for a drive, option or limit out of range, and for a Table over master
/// position. An integration that fails is an outcome: see DriveResult::integration.
DriveResult drive_through(const SignalView& reference, const Drive& drive,
                          const DriveOptions& options = {});

/// A Cam is no motion over time: follow it with a master first (Followed).
DriveResult drive_through(const Cam& reference, const Drive& drive,
                          const DriveOptions& options = {}) = delete;

}  // namespace jounce
