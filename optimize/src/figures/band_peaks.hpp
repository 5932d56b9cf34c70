// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/vibration/vibration_band.hpp"

namespace jounce::optimize_detail {

/// Returns the local peaks of the residual that a motion leaves in the modes of a band, each exact
/// to rounding, and the residual at the ends of the sides of the band. All peaks lie on the edge of
/// the band (profiles/src/vibration/vibration_band.cpp). worst_residual() is not enough here: it
/// proves its result to a share of the travel, and for a residual of a millionth of the travel that
/// does not determine where the peak is.
///
/// Each side is sampled at 25 places for each lobe of the spectrum, and each peak of the samples is
/// refined. Peaks that are closer together than two samples count as one.
std::vector<WorstMode> band_peaks(const Trajectory& motion, const ModeBand& band);

}  // namespace jounce::optimize_detail
