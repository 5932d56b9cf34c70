// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/rise.hpp"

namespace jounce {

/// A coefficient and the master position (m) at which the rise has it.
struct Coefficient {
  double value = 0;
  double where = 0;
};

/// The characteristic values of a rise (VDI 2143), normalized to stroke 1 over master length 1. For
/// stroke h, length b and a master at constant speed w, the slave's peaks are cv h w / b, ca h (w /
/// b)^2 and cj h (w / b)^3.
///
///     Characteristics c = characteristics(Cam(normalised(Law::modified_sine)));
///     double peak = c.cv.value;                    // 1.7596...
///
/// Cv, Ca and Cj are exact extrema (to rounding), the rms an exact quadrature; Cm is the value at
/// one position, and no other exceeds it by more than 1e-10 of it. Infinite values: Ca, Cm and rms
/// if the velocity steps, Cj if the acceleration steps, inside or against the neighbors (see
/// rises).
struct Characteristics {
  double stroke = 0;  ///< h, u, signed
  double length = 0;  ///< b, m

  Coefficient cv;        ///< max |f'|: velocity, and the static torque's factor
  Coefficient ca;        ///< max f'': towards the stroke
  Coefficient ca_star;   ///< max -f'': against it
  Coefficient cj;        ///< max |f'''|
  double cj_inside = 0;  ///< the same between the steps: finite
  Coefficient cm;        ///< max |f' f''|: dynamic torque
  double rms = 0;        ///< sqrt of the mean of f''^2

  /// max |f''|.
  [[nodiscard]] double peak_acceleration() const {
    return ca.value > ca_star.value ? ca.value : ca_star.value;
  }
};

Characteristics characteristics(const Rise& rise);

/// For a whole cam: a law, or any piece from one position to another. Throws InputError("stroke",
/// ...) if it ends at its start position.
Characteristics characteristics(const Cam& law);

}  // namespace jounce
