// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Magnitude and phase of the drive's loop over frequency (Bode), with its margins.
Figure bode_figure(const Drive& drive);

/// The loop in the complex plane (Nyquist), about the unit circle and -1.
Figure nyquist_figure(const Drive& drive);

/// Height of the plot, px, at which nyquist_figure() has equal scales.
inline constexpr double nyquist_height = 560;

/// The figure with this name, "bode" or "nyquist", of the drive in a spec or in one of its axes. It
/// needs no motion. Throws InputError for a file without a [drive], and for a spec of several axes
/// without the name of one (key "axis").
Figure loop_figure(const std::string& path, const std::string& axis, const std::string& which);

}  // namespace jounce
