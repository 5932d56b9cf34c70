// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Torque and following error over time, with their limits.
Figure response_figure(const DriveResult& run, const DriveSpec& drive, const std::string& unit);

/// The run in the plane of speed and torque, within what the motor has: peak torque, falling from the
/// rated to the greatest velocity; the continuous torque; and the point of mean speed and rms torque.
Figure torque_speed_figure(const DriveResult& run, const Drive& drive);

/// The amplitude in u that the motion leaves of a mode at its end, over the mode's frequency, undamped
/// and damped; marked where the drive itself swings. Exact at each of its frequencies.
Figure spectrum_figure(const Trajectory& motion, const Drive& drive, const std::string& unit);

/// By the names of `jounce plot --drive`: response, torque-speed, spectrum. Throws InputError for an
/// input without a [drive].
Figure drive_figure(const Input& input, const std::string& which);

}  // namespace jounce
