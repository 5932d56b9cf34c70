// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/rise.hpp"

namespace jounce {

/// A characteristic value, and the master position (m) at which it occurs. u is the slave's unit, m
/// the master's.
struct Coefficient {
  double value = 0;  ///< normalized, no unit
  double where = 0;  ///< m
};

/// The characteristic values of a rise (VDI 2143), normalized to stroke 1 and master length 1. For
/// stroke h, length b and a master at constant speed w, the peaks of the slave are: velocity cv h w
/// / b, acceleration ca h (w / b)^2, jerk cj h (w / b)^3.
///
///     Characteristics c = characteristics(Cam(normalized(Law::modified_sine)));
///     double peak = c.cv.value;                    // 1.7596...
///
/// Cv, Ca and Cj are exact extrema (to rounding); rms is an exact quadrature. Cm is the value at
/// one position, and no other position exceeds Cm by more than 1e-10 of its value. If the velocity
/// steps, Ca, Cm and rms are infinite; if the acceleration steps, Cj is infinite. A step counts
/// inside the rise and at its ends, against the neighbors (see rises()).
struct Characteristics {
  double stroke = 0;  ///< h, u, signed
  double length = 0;  ///< b, m

  Coefficient cv = {};       ///< Cv, max |f'|: velocity, and factor of the static torque
  Coefficient ca = {};       ///< Ca, max f'': acceleration in the direction of the stroke
  Coefficient ca_star = {};  ///< max -f'': acceleration against the direction of the stroke
  Coefficient cj = {};       ///< Cj, max |f'''|
  double cj_inside = 0;      ///< max |f'''| between steps; always finite
  Coefficient cm = {};       ///< Cm, max |f' f''|: factor of the dynamic torque
  double rms = 0;            ///< square root of the mean of f''^2

  /// The greater of ca and ca_star: max |f''|.
  [[nodiscard]] double peak_acceleration() const {
    return ca.value > ca_star.value ? ca.value : ca_star.value;
  }
};

/// Returns the characteristic values of a rise.
Characteristics characteristics(const Rise& rise);

/// Returns the characteristic values of a whole cam, as if it were one rise. Use it for a law or a
/// part of a cam. Throws InputError("stroke", ...) if the cam ends at its start position.
Characteristics characteristics(const Cam& law);

}  // namespace jounce
