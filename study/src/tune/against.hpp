// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/optimize/cam_shape.hpp"
#include "jounce/spec/drive_figures.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// The drive for optimizing a cam, and the speed of the master.
struct Against {
  Drive drive = {};     ///< position_per_rev in the slave's unit
  double velocity = 0;  ///< velocity of the master, units/s, > 0
  double settle = 0.2;  ///< s of standstill after the cam's end, for the residual
  bool periodic =
      false;           ///< the cam repeats endlessly: its steady state; then there is no residual
  int max_rounds = 8;  ///< max rounds for a drive that is not linear
};

/// The outcome of the shapes, and the behavior of the drive. Bounds hold only if the drive is
/// linear. `feasible` includes `real`; `rounds` counts the solutions of the shapes.
struct AgainstOutcome : CamShapeOutcome {
  DriveResult driven_given;  ///< the given cam, integrated
  DriveResult driven_best;   ///< the best cam, integrated
  /// Figures of the drive along the whole cam, by drive_through(): those of `minimize`, then of the ceilings.
  std::vector<FigureResult> driven_figures = {};
  /// By integration: no ceiling of the drive is exceeded, and the best cam is better than the given one.
  bool real = false;
};

/// Optimizes the free shapes of a cam through a model of the drive that follows it, from rest at
/// the cam's start to its end, which it then holds; or, if `periodic`, over one turn of the steady
/// state (exact_period()):
///
///     CamShapeProblem problem{.cam = cam, .shapes = {{.segment = 1}}};
///     problem.minimize = {{{asked(DriveFigure::torque)}}};
///     const AgainstOutcome outcome =
///         optimize_against(problem, {.drive = servo_400w(), .velocity = 360});
///     if (outcome.usable()) use(outcome.best);
///
/// A linear drive is convex in the shape: the result is the least value over the splines, at 500
/// instants of the cam, up to 500 of the standstill, and the peaks between them. A drive that is
/// not linear, or whose torque reaches its limit, is solved in rounds around its own run (equation
/// (2) in against.cpp). The slopes are those of the linear drive, so the result is better, but not
/// proven best. In both cases both cams are integrated (drive_through), and these runs decide.
///
/// `periodic` needs a linear drive.
///
/// Throws InputError like optimize_cam_shapes() and drive_through(), for segments that are not one
/// run within the cam, and if no figure is one of the drive.
AgainstOutcome optimize_against(const CamShapeProblem& problem, const Against& against,
                                const KeepGoing& keep_going = {});

}  // namespace jounce
