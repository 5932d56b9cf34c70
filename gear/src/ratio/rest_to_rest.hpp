// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/segment.hpp"

/// Laws from rest to rest over a cycle of the master, for the shear, the indexer and the
/// registration.
namespace jounce::gear_detail {

/// Peaks of a law over stroke 1 and length 1 (Cv, Ca, Cj). A peak is infinite if the next lower
/// derivative steps, inside the law or against the rest at its ends.
struct Peaks {
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
};

/// Throws InputError(key, ...) if the law does not go from rest to rest, has no shape of its own,
/// or does not accept the form.
void require_rest_to_rest(const char* key, Law law, const LawForm& form);

/// Peaks of a law from rest to rest.
Peaks peaks(const char* key, Law law, const LawForm& form = {});

/// The same for a law of the velocity from 0 to 1: a law from rest to rest, or the line.
Peaks peaks_of_ramp(const char* key, Law law);

/// x rounded to a multiple of the last digit of `cycle`. Sums of such lengths within a cycle are
/// exact, and so is the rest of the cycle: it closes to the bit.
double on_grid(double x, double cycle);

/// The pieces of the law over [from, from + length] as segments from 0 to 1. `from` and `length`
/// must be on the grid of the cycle; then all ends of segments are on it.
std::vector<Segment> placed(Law law, const LawForm& form, double from, double length, double cycle);

/// The law from u0 to u1. Its end value is exactly u1, if it has no sines.
std::vector<Segment> moved(Law law, const LawForm& form, double from, double length, double cycle,
                           double u0, double u1);

}  // namespace jounce::gear_detail
