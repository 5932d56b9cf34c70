// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/optimize/cam_shape.hpp"
#include "jounce/spec/detail/drive_figures.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// The drive through which a cam is optimized, and the speed of the master.
struct Against {
  Drive drive = {};     ///< the drive; its position_per_rev is in the unit of the slave
  double velocity = 0;  ///< speed of the master, master units/s, > 0
  /// Standstill after the end of the cam, in which the residual vibration is measured, s.
  double settle = 0.2;
  /// True: the cam repeats without end, and its steady state counts; there is no residual.
  bool periodic = false;
  int max_rounds = 8;  ///< greatest number of rounds for a drive that is not linear
};

/// Result of optimize_against(): the result of the shapes, and the behavior of the drive. Its
/// bounds are valid only if the drive is linear. `feasible` requires `real`. `rounds` is the number
/// of times that the shapes were solved.
struct AgainstOutcome : CamShapeOutcome {
  DriveResult driven_given;  ///< result of drive_through() for the given cam
  DriveResult driven_best;   ///< result of drive_through() for the best cam
  /// Figures of the drive over the whole cam, from drive_through(): the figures of `minimize`, then
  /// the figures of the ceilings.
  std::vector<FigureResult> driven_figures = {};
  /// True if, by integration, no ceiling of the drive is exceeded and the best cam is better than
  /// the given one.
  bool real = false;
};

/// Optimizes the free shapes of a cam through a model of the drive that follows it. The drive moves
/// from rest at the start of the cam to its end, and holds the end. With `periodic`, one period of
/// the steady state counts (exact_period()).
///
///     CamShapeProblem problem{.cam = cam, .shapes = {{.segment = 1}}};
///     problem.minimize = {{{asked(DriveFigure::torque)}}};
///     const AgainstOutcome outcome =
///         optimize_against(problem, {.drive = servo_400w(), .velocity = 360});
///     if (outcome.usable()) use(outcome.best);
///
/// For a linear drive, the problem is convex in the shape. The result is the minimum over the
/// splines, at 500 instants of the cam, up to 500 instants of the standstill, and the peaks between
/// them. A drive that is not linear, or whose torque reaches its limit, is solved in rounds, each
/// around the run of the previous one (equation (2) in against.cpp). The slopes belong to the
/// linear drive, so the result is an improvement, but not proven to be the best. In both cases,
/// both cams are integrated by drive_through(), and these runs decide.
///
/// `periodic` requires a linear drive. Throws InputError like optimize_cam_shapes() and
/// drive_through(), for free segments that do not form one run within the cam, and if no figure is
/// a figure of the drive.
AgainstOutcome optimize_against(const CamShapeProblem& problem, const Against& against,
                                const KeepGoing& keep_going = {});

}  // namespace jounce
