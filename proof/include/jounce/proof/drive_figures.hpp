// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Returns torque and following error of a drive over time, with their limits. `unit`: unit of the
/// position.
Figure response_figure(const DriveResult& run, const DriveSpec& drive, const std::string& unit);

/// Returns the motion of the motor in the plane of speed and torque, with the limits of the motor:
/// the peak torque, which falls between the rated and the greatest velocity, and the continuous
/// torque. A mark shows the mean speed and the rms torque.
Figure torque_speed_figure(const DriveResult& run, const Drive& drive);

/// Returns the residual vibration of a mode after the motion, as a function of the mode's
/// frequency, without and with damping, in dB relative to the travel. The modes of the drive are
/// marked. Values are exact at each frequency shown. `unit` is the unit of the position.
Figure spectrum_figure(const Trajectory& motion, const Drive& drive, const std::string& unit);

/// Returns the figure with this name of `jounce plot --drive`: "response", "torque-speed" or
/// "spectrum". Throws InputError for an input without a [drive], and for "spectrum" if the master
/// of a cam accelerates.
Figure drive_figure(const Input& input, const std::string& which);

/// Returns the options for drawing the figure with this name, of drive_figure() or loop_figure().
SvgOptions drive_look(const std::string& which);

}  // namespace jounce
