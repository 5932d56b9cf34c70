// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "jounce/optimize/shape.hpp"

/// Figures of [optimize] that are of a drive: `jounce optimize --against drive.toml`.
namespace jounce {

enum class DriveFigure {
  torque,               ///< "drive torque": peak, N m
  rms_torque,           ///< "drive rms torque": N m
  residual,             ///< "drive residual": u, peak of load - reference after the end
  following_error,      ///< "drive following error": u, peak of reference - motor
  end_following_error,  ///< "drive end following error": u, at the end
};

inline constexpr std::array all_drive_figures{DriveFigure::torque, DriveFigure::rms_torque,
                                              DriveFigure::residual, DriveFigure::following_error,
                                              DriveFigure::end_following_error};

std::string name(DriveFigure figure);

/// Nothing for another name.
std::optional<DriveFigure> drive_figure(const std::string& name);

/// The figure as a spec that is read asks for it: a response whose function is not known before the
/// drive is.
ShapeFigure asked(DriveFigure figure);

/// The drive's figure that a shape's figure is, by its name.
std::optional<DriveFigure> drive_figure(const ShapeFigure& figure);

}  // namespace jounce
