// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/vibration/vibration_band.hpp"

namespace jounce::optimizer {

/// The local peaks of what the modes of a band keep of a motion, each within rounding of itself, and the ends of the
/// band's sides. All lie on the edge of the band (profiles/src/vibration/vibration_band.cpp). worst_residual() proves its answer to a
/// share of the motion's travel; beside a motion that leaves a millionth of it, that is not enough to say where.
///
/// Each side is sampled at 25 places a lobe of the spectrum, and each peak of these samples is narrowed. Peaks closer
/// together than two samples are one.
std::vector<WorstMode> band_peaks(const Trajectory& motion, const ModeBand& band);

}  // namespace jounce::optimizer
