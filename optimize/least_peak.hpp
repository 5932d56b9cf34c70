#pragma once

#include "jounce/cam/design.hpp"

namespace jounce {

/// A cam whose left-out derivatives were chosen for the least max |geo_acceleration|.
struct LeastPeak {
  CamSpec cam;      ///< every derivative filled in
  double peak = 0;  ///< its max |geo_acceleration|, u/m^2, exact
  /// Certificate: no choice of what was left out is below, u/m^2.
  double bound = 0;
};

/// Fill "minimum_peak_acceleration": what the spec leaves out (see cam/boundaries.hpp for what
/// counts) is chosen for the least max |geo_acceleration| over the whole cam. Where that leaves a
/// choice, as it does in every stretch that is not the hardest, the least of the second hardest, and
/// so on?
LeastPeak filled_for_least_peak(const CamSpec& spec);

}  // namespace jounce
