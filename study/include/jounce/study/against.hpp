// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/optimize/cam_shape.hpp"
#include "jounce/spec/drive_figures.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// The drive that a cam is optimized against, and how fast the master turns.
struct Against {
  Drive drive = {};     ///< position_per_rev in the slave's unit
  double velocity = 0;  ///< velocity of the master, units a second, > 0
  double settle = 0.2;  ///< s of standstill after the cam's end, for the residual
  bool periodic =
      false;           ///< the cam repeats endlessly: its steady state; then there is no residual
  int max_rounds = 8;  ///< max rounds of a drive that is not linear
};

/// The outcome of the shapes, and the behavior of the drive. Bounds hold only where the drive is linear.
/// `feasible` includes `real`; `rounds` counts the solutions of the shapes.
struct AgainstOutcome : CamShapeOutcome {
  DriveResult driven_given;  ///< the given cam, integrated
  DriveResult driven_best;   ///< the best cam, integrated
  /// Figures of the drive along the whole cam, by drive_through(): those of `minimize`, then of the ceilings.
  std::vector<FigureResult> driven_figures = {};
  /// By integration: no ceiling of the drive is exceeded, and the best cam is better than the given one.
  bool real = false;
};

/// Optimizes the free shapes of a cam through a model of the drive that follows it, from rest at the cam's
/// start, once, and then holds its end; or, `periodic`, over one turn of the steady state (exact_period()):
///
///     CamShapeProblem problem{.cam = cam, .shapes = {{.segment = 1}}};
///     problem.minimize = {{{asked(DriveFigure::torque)}}};
///     const AgainstOutcome outcome =
///         optimize_against(problem, {.drive = servo_400w(), .velocity = 360});
///     if (outcome.usable()) use(outcome.best);
///
/// A linear drive is convex in the shape: the result is the least value over the splines, at 500
/// instants of the cam and as many of the standstill, at most 1000, and at the peaks between
/// them. A drive that is not linear, and one whose torque meets its limit, is solved by rounds around its
/// own run (equation (2) in against.cpp); the slopes are those of the linear drive, so that the result is
/// better, not proven best. Either way both cams are integrated (drive_through), and these runs decide.
///
/// A periodic one needs a linear drive.
///
/// Throws InputError as optimize_cam_shapes() and drive_through() do, for segments that are not one run
/// within the cam, and where no figure is of the drive.
AgainstOutcome optimize_against(const CamShapeProblem& problem, const Against& against,
                                const KeepGoing& keep_going = {});

}  // namespace jounce
