// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "jounce/optimize/shape.hpp"

/// Key figures of a drive for [optimize]: `jounce optimize --against drive.toml`.

namespace jounce {

/// A key figure of a drive. u is the unit of the slave.
enum class DriveFigure {
  torque,      ///< "drive torque": peak torque, N m
  rms_torque,  ///< "drive rms torque": N m
  residual,    ///< "drive residual": u, peak of load minus reference after the end of the motion
  following_error,  ///< "drive following error": u, peak of reference minus motor
  /// "drive end following error": u, reference minus motor at the end of the motion.
  end_following_error,
};

inline constexpr std::array all_drive_figures{DriveFigure::torque, DriveFigure::rms_torque,
                                              DriveFigure::residual, DriveFigure::following_error,
                                              DriveFigure::end_following_error};

std::string name(DriveFigure figure);  ///< the name in the spec

/// Returns the figure with this name; nullopt if no figure has the name.
std::optional<DriveFigure> drive_figure(const std::string& name);

/// Returns the figure as read_spec() (spec.hpp) stores it: a ResponseOf or RmsResponseOf without a
/// function, because the drive that the function needs is not given yet.
ShapeFigure asked(DriveFigure figure);

/// Returns the figure of a drive for a figure of a shape, by its name; nullopt if the shape's
/// figure is not a figure of a drive.
std::optional<DriveFigure> drive_figure(const ShapeFigure& figure);

}  // namespace jounce
