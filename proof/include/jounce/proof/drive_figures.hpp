// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Torque and following error over time, with their limits.
Figure response_figure(const DriveResult& run, const DriveSpec& drive, const std::string& unit);

/// The run in the plane of speed and torque, in the envelope of the motor: peak torque, which falls from the rated to
/// the greatest velocity; the continuous torque; the point of mean speed and rms torque.
Figure torque_speed_figure(const DriveResult& run, const Drive& drive);

/// Residual vibration of a mode after the motion over the frequency of the mode, undamped and damped, in dB of the
/// travel; `unit` of the position. The modes of the drive are marked. Exact at each frequency shown.
Figure spectrum_figure(const Trajectory& motion, const Drive& drive, const std::string& unit);

/// The figure with this name of `jounce plot --drive`: response, torque-speed, spectrum. Throws InputError for an input
/// without a [drive].
Figure drive_figure(const Input& input, const std::string& which);

/// The look of the figure with this name, of drive_figure() or loop_figure().
SvgOptions drive_look(const std::string& which);

}  // namespace jounce
