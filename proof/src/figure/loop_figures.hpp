// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/proof/any_figure.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Returns the Bode diagram of the drive's open loop: magnitude and phase over frequency, with the
/// margins.
Figure bode_figure(const Drive& drive);

/// Returns the Nyquist diagram: the open loop in the complex plane, with the unit circle and the
/// point -1.
Figure nyquist_figure(const Drive& drive);

/// Height of the plot at which nyquist_figure() has the same scale on both axes, px.
inline constexpr double nyquist_height = 560;

/// Returns the figure with the name request.drive, "bode" or "nyquist", for the drive in a spec or in one of its
/// axes. The spec needs no motion. Throws InputError for a file without a [drive], and for a spec
/// of several axes if `axis` is empty (key "axis").
Figure loop_figure(const FigureRequest& request);

}  // namespace jounce
