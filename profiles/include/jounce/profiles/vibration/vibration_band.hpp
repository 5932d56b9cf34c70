// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>

#include "jounce/profiles/vibration/vibration.hpp"

namespace jounce {

/// Returns the residual vibration after a motion as a phasor, in u. The magnitude of the phasor is
/// residual_vibration(). The phasor of a sum of motions over the same time is the sum of their
/// phasors. Throws InputError for a mode out of range.
std::complex<double> residual_phasor(const Trajectory& motion, const Mode& mode);

/// The possible modes of a machine: all frequencies and dampings within these ranges.
struct ModeBand {
  double low = 0;           ///< Hz, > 0
  double high = 0;          ///< Hz, >= low; equal to low for a single frequency
  double damping_low = 0;   ///< D, a ratio, >= 0
  double damping_high = 0;  ///< >= damping_low, < 1
};

/// The mode of a band with the greatest residual vibration.
struct WorstMode {
  double residual = 0;  ///< residual_vibration(motion, mode), u
  Mode mode = {};
};

/// Returns the mode of a band with the greatest residual_vibration().
///
///     const ModeBand band{.low = 14.5, .high = 19.5, .damping_high = 0.05};
///     const WorstMode worst = worst_residual(move, band);
///
/// No mode of the band exceeds the result by more than `tolerance` times the travel of the motion
/// (the sum of all distances, forwards and backwards). The search covers only the boundary of the
/// band, because no mode inside can be worse (see vibration_band.cpp). Throws InputError for a band
/// out of range, or a tolerance outside 1e-12 to 1.
WorstMode worst_residual(const Trajectory& motion, const ModeBand& band, double tolerance = 1e-6);

}  // namespace jounce
