// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/segment.hpp"

/// Laws from rest to rest on a cycle of the master: what shear, indexer and registration share.
namespace jounce::gearing {

/// Peaks of a law over stroke 1 and length 1: Cv, Ca, Cj; infinite where the one before steps, also
/// against the rest beside it.
struct Peaks {
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
};

/// Throws InputError(key, ...) unless the law goes from rest to rest and has a shape of its own, and
/// for a form that it does not take.
void require_rest_to_rest(const char* key, Law law, const LawForm& form);

/// Peaks of such a law.
Peaks peaks(const char* key, Law law, const LawForm& form = {});

/// For a law that a speed follows from 0 to 1: those, or the line.
Peaks peaks_of_ramp(const char* key, Law law);

/// x rounded to a multiple of the last digit of `cycle`. Positions within a cycle that are sums of
/// such lengths have no rounding, and neither has what is left of the cycle: it closes to the bit.
double on_grid(double x, double cycle);

/// The pieces of the law from `from` to `from` + `length`, both on the cycle's grid, as segments whose
/// ends are on it, too. Their values are still those from 0 to 1.
std::vector<Segment> placed(Law law, const LawForm& form, double from, double length, double cycle);

/// The law from u0 to u1, ending in u1 exactly where it has no sines.
std::vector<Segment> moved(Law law, const LawForm& form, double from, double length, double cycle,
                           double u0, double u1);

}  // namespace jounce::gearing
